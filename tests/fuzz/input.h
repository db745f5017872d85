// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/text.h"

/// Code that the targets share. A target catches documented errors; any other exception ends the target and is
/// reported as found.
namespace poinsot::fuzz {

using Bytes = std::span<const std::uint8_t>;

inline std::string_view textOf(Bytes bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

/// Splits bytes at a separator. Returns at least one word, which may be empty.
inline std::vector<std::string> wordsOf(Bytes bytes, char between) {
  std::vector<std::string> words{""};
  for (const std::uint8_t byte : bytes)
    if (static_cast<char>(byte) == between)
      words.emplace_back();
    else
      words.back() += static_cast<char>(byte);
  return words;
}

/// Aborts if a message has characters that could move a terminal's cursor, colour it or reverse its text.
inline void expectPrintable(std::string_view message) {
  for (std::size_t i = 0; i < message.size();) {
    if (message[i] == '\n' || (message[i] >= ' ' && message[i] <= '~')) {
      ++i;
      continue;
    }
    const std::size_t length = core::firstCodePoint(message.substr(i)).length;
    const std::string_view one = message.substr(i, length);
    if (length == 0 || core::printable(one) != one) std::abort();
    i += length;
  }
}

}  // namespace poinsot::fuzz
