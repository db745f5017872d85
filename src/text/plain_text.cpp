// SPDX-License-Identifier: Apache-2.0
#include "text/plain_text.h"

namespace poinsot::text {
namespace {

constexpr std::u32string_view kOnTheLine = U"0123456789+−=()";
constexpr std::u32string_view kLowered = U"₀₁₂₃₄₅₆₇₈₉₊₋₌₍₎";
constexpr std::u32string_view kRaised = U"⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁼⁽⁾";

std::u32string grouped(const std::u32string& part) { return part.size() > 1 ? U"(" + part + U")" : part; }

// Returns a part of a quotient, in parentheses if it is a sum or a quotient. A product such as "2T" needs none.
std::u32string quotientPart(const std::u32string& part) {
  return part.find_first_of(U" /+−") == part.npos ? part : grouped(part);
}

// Returns a script in Unicode's small characters if all exist, as in "₁₂"; otherwise after TeX's `sign`.
std::u32string script(const std::u32string& content, std::u32string_view small, char32_t sign) {
  std::u32string mapped;
  for (const char32_t c : content) {
    const auto at = kOnTheLine.find(c);
    if (at == kOnTheLine.npos) return sign + grouped(content);
    mapped += small[at];
  }
  return mapped;
}

}  // namespace

std::string toUtf8(std::u32string_view characters) {
  std::string utf8;
  for (const char32_t c : characters) {
    if (c < 0x80) {
      utf8 += static_cast<char>(c);
      continue;
    }
    const int more = c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;
    constexpr unsigned kLead[] = {0, 0xc0, 0xe0, 0xf0};
    utf8 += static_cast<char>(kLead[more] | (c >> (6 * more)));
    for (int i = more - 1; i >= 0; --i) utf8 += static_cast<char>(0x80 | ((c >> (6 * i)) & 0x3f));
  }
  return utf8;
}

std::u32string plainSubscript(const std::u32string& content) { return script(content, kLowered, U'_'); }

std::u32string plainSuperscript(const std::u32string& content) {
  if (content == U"∘") return U"°";
  return script(content, kRaised, U'^');
}

std::u32string plainFraction(const std::u32string& numerator, const std::u32string& denominator) {
  return quotientPart(numerator) + U"/" + quotientPart(denominator);
}

std::u32string plainRoot(const std::u32string& content) { return U"√" + grouped(content); }

std::u32string plainMatrix(const std::vector<std::vector<std::u32string>>& rows) {
  std::u32string text;
  for (const std::vector<std::u32string>& row : rows) {
    text += text.empty() ? U"[" : U"; ";
    for (std::size_t i = 0; i < row.size(); ++i) text += (i == 0 ? U"" : U" ") + row[i];
  }
  return text + U"]";
}

std::u32string plainWithIndex(const std::u32string& index, const std::u32string& root) {
  if (index == U"3") return U"∛" + root.substr(1);
  if (index == U"4") return U"∜" + root.substr(1);
  const bool small = index.find_first_not_of(kOnTheLine) == index.npos;
  return (small ? plainSuperscript(index) : U"[" + index + U"]") + root;
}

}  // namespace poinsot::text
