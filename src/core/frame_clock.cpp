// SPDX-License-Identifier: Apache-2.0
#include "core/frame_clock.h"

#include <charconv>
#include <cmath>
#include <string_view>

#include "core/expect.h"

namespace poinsot::core {
namespace {

__extension__ using Wide = unsigned __int128;  // 128 bits, because digits (10^17) times num (10^9) exceed 64 bits

struct Decimal {
  std::uint64_t digits = 0;
  int exponent = 0;
};

Decimal shortestDecimal(double value) {
  char buffer[64];
  const auto written = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific);
  const std::string_view text(buffer, static_cast<std::size_t>(written.ptr - buffer));
  const auto mark = text.find('e');
  Decimal decimal;
  bool fraction = false;
  for (const char c : text.substr(0, mark)) {
    if (c == '.') {
      fraction = true;
      continue;
    }
    decimal.digits = decimal.digits * 10 + static_cast<std::uint64_t>(c - '0');
    decimal.exponent -= fraction;
  }
  // Skips the '+' of an exponent such as "e+01", because std::from_chars rejects it.
  const auto power = text.substr(mark + (text[mark + 1] == '+' ? 2 : 1));
  int exponent = 0;
  std::from_chars(power.data(), power.data() + power.size(), exponent);
  decimal.exponent += exponent;
  return decimal;
}

}  // namespace

double filmTime_s(std::int64_t k, const Rational& fps) {
  // k * den is exact in a double up to 2^53, so only the division rounds.
  return static_cast<double>(k * fps.den) / static_cast<double>(fps.num);
}

std::int64_t frameCount(double duration_s, const Rational& fps) {
  POINSOT_EXPECT(std::isfinite(duration_s) && duration_s > 0 && duration_s <= 1e9);
  // The number of k with k * den < duration * num is the ceiling of digits * num * 10^exponent / den.
  const Decimal duration = shortestDecimal(duration_s);
  Wide above = static_cast<Wide>(duration.digits) * static_cast<Wide>(fps.num);
  Wide below = static_cast<Wide>(fps.den);
  for (int i = 0; i < duration.exponent; ++i) above *= 10;
  // A quotient below 1 gives one frame. Returns early, because `below` would overflow.
  for (int i = 0; i < -duration.exponent; ++i) {
    if (below > above) return 1;
    below *= 10;
  }
  return static_cast<std::int64_t>((above + below - 1) / below);
}

}  // namespace poinsot::core
