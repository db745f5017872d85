// SPDX-License-Identifier: Apache-2.0
#include "core/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace poinsot::core {
namespace {

constexpr int kLongestShown = 200;
constexpr std::size_t kTellingPart = 3;   // shortest word that identifies a candidate by being part of it
constexpr std::size_t kTellingBegin = 5;  // shortest common beginning that identifies a candidate

std::size_t commonBegin(std::string_view a, std::string_view b) {
  return static_cast<std::size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
}

bool unsafe(char32_t c) {
  const bool control = c < 0x20 || (c >= 0x7f && c < 0xa0);
  const bool bidi =
      (c >= 0x202a && c <= 0x202e) || (c >= 0x2066 && c <= 0x206f) || c == 0x200e || c == 0x200f || c == 0x061c;
  const bool separator = c == 0x2028 || c == 0x2029;
  const bool unseen = c == 0xfeff || (c >= 0xfff9 && c <= 0xfffb) || (c >= 0xe0000 && c <= 0xe007f) ||
                      (c & 0xfffe) == 0xfffe;  // the last two code points of each plane are noncharacters
  return control || bidi || separator || unseen;
}

/// Moves one character, or one byte that is not UTF-8, from `text` to the end of `shown`, escaped if unsafe.
void appendShown(std::string_view& text, std::string& shown) {
  const CodePoint c = firstCodePoint(text);
  const std::size_t length = std::max<std::size_t>(c.length, 1);
  if (c.length > 0 && !unsafe(c.value))
    shown += text.substr(0, length);
  else if (c.length > 0 && c.value >= 0x100)
    shown += fmt::format("\\u{{{:x}}}", static_cast<std::uint32_t>(c.value));
  else
    shown += fmt::format("\\x{:02x}",
                         c.length > 0 ? static_cast<std::uint32_t>(c.value) : static_cast<unsigned char>(text[0]));
  text.remove_prefix(length);
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
  if (value < kSmallest[length] || value > 0x10ffff || surrogate) return {};
  return {value, length};
}

int editDistance(std::string_view a, std::string_view b) {
  // Optimal string alignment distance. Keeps three rows, because a swap of neighbours refers two rows back.
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
  // Finds the candidate "omega_body" for the word "omega".
  for (const std::string& candidate : candidates)
    if (candidate.find(word) != std::string::npos) return candidate;
  // Finds the candidate "gravity" for the word "gravitation".
  for (const std::string& candidate : candidates)
    if (commonBegin(word, candidate) >= kTellingBegin) return candidate;
  return best;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

std::string lowered(std::string_view text) {
  std::string small(text);
  for (char& c : small)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return small;
}

std::string smallLettersHint(std::string_view name, const std::vector<std::string>& endings) {
  const std::size_t dot = std::min(name.rfind('.'), name.size());
  const std::string ending = lowered(name.substr(dot));
  if (ending == name.substr(dot) || std::ranges::find(endings, ending) == endings.end()) return "";
  return "; write the ending in lower case: " + printable(std::string(name.substr(0, dot)) + ending);
}

std::string printable(std::string_view untrusted) {
  std::string shown;
  for (int count = 0; !untrusted.empty(); ++count) {
    if (count == kLongestShown) return shown + "…";
    appendShown(untrusted, shown);
  }
  return shown;
}

std::string printableLines(std::string_view untrusted) {
  std::string shown;
  while (!untrusted.empty()) {
    // Copies a run of plain characters at once for speed, because most text is plain.
    const auto plain = [](char c) { return (c >= ' ' && c < 0x7f) || c == '\n' || c == '\t'; };
    const auto end = std::ranges::find_if_not(untrusted, plain);
    shown.append(untrusted.begin(), end);
    untrusted.remove_prefix(static_cast<std::size_t>(end - untrusted.begin()));
    if (!untrusted.empty()) appendShown(untrusted, shown);
  }
  return shown;
}

std::string xmlText(std::string_view text) {
  std::string escaped;
  for (const char c : text)
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else
      escaped += c;
  return escaped;
}

std::string xmlAttribute(std::string_view text) {
  std::string escaped;
  for (const char c : xmlText(text))
    if (c == '"')
      escaped += "&quot;";
    else
      escaped += c;
  return escaped;
}

}  // namespace poinsot::core
