// SPDX-License-Identifier: Apache-2.0
#include "scene/document/arithmetic.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/number.h"
#include "core/text.h"

namespace poinsot::scene {
namespace {

std::optional<double> factorOf(std::string_view text) {
  const std::string word = core::lowered(core::trimmed(text));
  for (const std::string_view pi : {"pi", "π", "np.pi", "math.pi", "numpy.pi"}) {
    if (word == pi) return std::numbers::pi;
    if (word.size() > pi.size() && word.ends_with(pi))  // 2pi
      if (const auto times = core::parseNumber(std::string_view(word).substr(0, word.size() - pi.size())))
        return *times * std::numbers::pi;
  }
  return core::parseNumber(word);
}

}  // namespace

std::optional<double> arithmeticIn(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  text = core::trimmed(text);
  if (text.size() > kLongest || text.empty()) return std::nullopt;
  double value = 1;
  if (text.starts_with('-')) {
    value = -1;
    text.remove_prefix(1);
  }
  const bool hasPi = text.find("pi") != text.npos || text.find("π") != text.npos;
  if (!hasPi && text.find_first_of("*/") == text.npos) return std::nullopt;
  char operation = '*';
  while (true) {
    const std::size_t end = std::min(text.find_first_of("*/"), text.size());
    const auto factor = factorOf(text.substr(0, end));
    if (!factor || (operation == '/' && *factor == 0)) return std::nullopt;
    value = operation == '*' ? value * *factor : value / *factor;
    if (end == text.size()) break;
    operation = text[end];
    text.remove_prefix(end + 1);
  }
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace poinsot::scene
