// SPDX-License-Identifier: Apache-2.0
#include "cli/time_word.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/number.h"
#include "core/text.h"
#include "scene/units.h"

namespace poinsot::cli {

double parseTime_s(std::string_view option, const std::string& word) {
  if (const auto seconds = core::parseNumber(word)) return *seconds;
  const auto quantity = scene::parseQuantity(word, scene::Dimension::kTime);
  if (!quantity.ok())
    throw core::Error(core::ErrorKind::kUsage,
                      fmt::format("{} '{}': {}", option, core::printable(word), quantity.problem));
  return quantity.value;
}

std::vector<double> parseTimes_s(std::string_view option, std::string_view words) {
  std::vector<double> times_s;
  for (bool last = false; !last;) {
    const auto comma = words.find(',');
    last = comma == std::string_view::npos;
    std::string_view word = words.substr(0, comma);
    while (word.starts_with(' ')) word.remove_prefix(1);
    while (word.ends_with(' ')) word.remove_suffix(1);
    times_s.push_back(parseTime_s(option, std::string(word)));
    if (!last) words.remove_prefix(comma + 1);
  }
  return times_s;
}

}  // namespace poinsot::cli
