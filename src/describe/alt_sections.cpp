// SPDX-License-Identifier: Apache-2.0
#include "describe/alt_sections.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "describe/language.h"

namespace poinsot::describe {

namespace {

constexpr double kZeroBelow = 1e-12;  // relative to `scale`; a few thousand rounding errors of a double

std::string raised(int exponent) {
  constexpr const char* kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(exponent))) text += kDigits[digit - '0'];
  return text;
}

std::string threeDigits(double value) {
  std::string text = fmt::format("{:.3g}", value);
  if (hasDecimalComma()) std::ranges::replace(text, '.', ',');
  return text;
}

}  // namespace

std::string numberWords(double value, double scale) {
  if (value == 0 || std::abs(value) <= kZeroBelow * std::abs(scale)) return "0";
  const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
  if (exponent < -4 || exponent > 5)
    return fmt::format("{} × 10{}", threeDigits(value / std::pow(10.0, exponent)), raised(exponent));
  if (exponent < 3) return threeDigits(value);
  const double unit = std::pow(10.0, exponent - 2);
  return fmt::format("{:.0f}", std::round(value / unit) * unit);
}

std::string timeWords(double time_s) {
  if (std::isinf(time_s)) return say("an infinite time");
  const double size = std::abs(time_s);
  if (size < 0.1 && size > 0) return numberWords(1e3 * time_s) + " ms";
  if (size < 120) return numberWords(time_s) + " s";
  if (size < 7200) return say("{} minutes", numberWords(time_s / 60));
  if (size < 172800) return say("{} hours", numberWords(time_s / 3600));
  return say("{} days", numberWords(time_s / 86400));
}

std::string lengthWords(double length_m) {
  return std::abs(length_m) < 1 ? numberWords(100 * length_m) + " cm" : numberWords(length_m) + " m";
}

std::string angleWords(double angle_rad) { return numberWords(angle_rad * 180 / std::numbers::pi, 180) + "°"; }

std::string rateWords(double rate) { return numberWords(rate) + " rad/s"; }

std::string turningWords(double rate) {
  constexpr double kTooFastToTime_s = 0.5;
  const double turn_s = 2 * std::numbers::pi / rate;
  if (turn_s < kTooFastToTime_s) return say("{}, {} turns a second", rateWords(rate), numberWords(1 / turn_s));
  return say("{}, one turn in {}", rateWords(rate), timeWords(turn_s));
}

std::string listWords(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? say(" and ") : ", ";
    text += words[i];
  }
  return text;
}

}  // namespace poinsot::describe
