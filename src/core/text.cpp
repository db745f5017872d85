// SPDX-License-Identifier: Apache-2.0
#include "core/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace poinsot::core {
namespace {

constexpr int kLongestShown = 200;
constexpr std::size_t kTellingPart = 3;  // letters that make a part of a word enough to tell it

bool unsafe(char32_t c) {
  const bool control = c < 0x20 || (c >= 0x7f && c < 0xa0);
  const bool bidi = (c >= 0x202a && c <= 0x202e) || (c >= 0x2066 && c <= 0x2069) || c == 0x200e || c == 0x200f;
  return control || bidi || c == 0x2028 || c == 0x2029 || c == 0xfeff;
}

}  // namespace

CodePoint firstCodePoint(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : lead >= 0xc0 ? 2 : 0;
  if (length == 0 || length > text.size() || lead > 0xf4) return {};
  char32_t value = lead & (0x7fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return {};
    value = value << 6 | (byte(i) & 0x3f);
  }
  constexpr char32_t kSmallest[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = value >= 0xd800 && value <= 0xdfff;
  if (value < kSmallest[length] || value > 0x10ffff || surrogate) return {};  // overlong or no character
  return {value, length};
}

int editDistance(std::string_view a, std::string_view b) {
  // Optimal string alignment: three rows, as a swap of neighbours looks two rows back.
  std::vector<int> twoBack(b.size() + 1), previous(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) previous[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replaced = previous[j - 1] + (a[i - 1] != b[j - 1]);
      row[j] = std::min({previous[j] + 1, row[j - 1] + 1, replaced});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], twoBack[j - 2] + 1);
    }
    std::swap(twoBack, previous);
    std::swap(previous, row);
  }
  return previous[b.size()];
}

std::optional<std::string> closest(std::string_view word, const std::vector<std::string>& candidates) {
  std::optional<std::string> best;
  int least = static_cast<int>(std::max<std::size_t>(word.size() / 3, word.size() < 5 ? 1 : 2)) + 1;
  for (const std::string& candidate : candidates) {
    const int distance = editDistance(word, candidate);
    const bool nothingLeft = distance >= static_cast<int>(std::max(word.size(), candidate.size()));
    if (distance < least && !nothingLeft) {
      least = distance;
      best = candidate;
    }
  }
  if (best || word.size() < kTellingPart) return best;
  // "omega" for "omega_body", "moments" for "principal_moments".
  for (const std::string& candidate : candidates)
    if (candidate.find(word) != std::string::npos) return candidate;
  return best;
}

std::string printable(std::string_view untrusted) {
  std::string shown;
  for (int count = 0; !untrusted.empty(); ++count) {
    if (count == kLongestShown) return shown + "…";
    const CodePoint c = firstCodePoint(untrusted);
    if (c.length == 0) {
      shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(untrusted[0]));
      untrusted.remove_prefix(1);
      continue;
    }
    if (!unsafe(c.value))
      shown += untrusted.substr(0, c.length);
    else if (c.value < 0x100)
      shown += fmt::format("\\x{:02x}", static_cast<std::uint32_t>(c.value));
    else
      shown += fmt::format("\\u{{{:x}}}", static_cast<std::uint32_t>(c.value));
    untrusted.remove_prefix(c.length);
  }
  return shown;
}

}  // namespace poinsot::core
