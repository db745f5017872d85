// SPDX-License-Identifier: Apache-2.0
#include "compare/picture_origin.h"

#include <fmt/format.h>

#include <vector>

#include "core/text.h"

namespace poinsot::compare {

std::string originChange(const PictureOrigin& approved, const PictureOrigin& drawn) {
  std::vector<std::string> before, now;
  for (const auto fact : {&PictureOrigin::software, &PictureOrigin::driver, &PictureOrigin::renderer}) {
    const std::string &one = approved.*fact, &other = drawn.*fact;
    if (one.empty() || other.empty() || one == other) continue;
    before.push_back(core::printable(one));
    now.push_back(core::printable(other));
  }
  if (before.empty()) return "";
  return fmt::format("approved by {}, drawn by {}", core::joined(before, " with "), core::joined(now, " with "));
}

}  // namespace poinsot::compare
