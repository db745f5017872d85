// SPDX-License-Identifier: Apache-2.0
#include "core/expect.h"

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>

namespace poinsot::core {

void brokenContract(const char* condition, const char* file, int line) {
  // Removes the folder of the build machine from the path, because it is of no use in a message.
  const std::string_view path(file);
  const auto src = path.rfind("/src/");
  const std::string_view shown = src == std::string_view::npos ? path : path.substr(src + 1);
  throw std::logic_error(fmt::format("broken contract: {} ({}:{})", condition, shown, line));
}

}  // namespace poinsot::core
