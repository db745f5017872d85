// SPDX-License-Identifier: Apache-2.0
#include "output/h264_stream.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace poinsot::output {
namespace {

constexpr std::array<std::uint8_t, 3> kStartCode = {0, 0, 1};
constexpr std::array<std::uint8_t, 16> kX264Uuid = {0xdc, 0x45, 0xe9, 0xbd, 0xe6, 0xd9, 0x48, 0xb7,
                                                    0x96, 0x2c, 0xd8, 0x20, 0xd9, 0x23, 0xee, 0xef};

/// Returns the position of the next start code at or after `from`, including the zero byte that may precede the
/// code. Returns the stream's size if there is no start code.
std::size_t nextUnit(std::span<const std::uint8_t> stream, std::size_t from) {
  const auto found = std::search(stream.begin() + static_cast<std::ptrdiff_t>(from), stream.end(),
                                 kStartCode.begin(), kStartCode.end());
  auto at = static_cast<std::size_t>(found - stream.begin());
  if (at < stream.size() && at > from && stream[at - 1] == 0) --at;
  return at;
}

std::span<const std::uint8_t> payload(std::span<const std::uint8_t> unit) {
  const auto code = std::search(unit.begin(), unit.end(), kStartCode.begin(), kStartCode.end());
  if (code == unit.end()) return {};
  return unit.subspan(static_cast<std::size_t>(code - unit.begin()) + kStartCode.size());
}

/// Returns x264's note, without its UUID, from a user data message; empty for every other unit. An SEI message
/// consists of its type, its size and its content (H.264, 7.3.2.3.1). The size is a number of bytes of 255 and a
/// last smaller byte.
std::span<const std::uint8_t> noteOf(std::span<const std::uint8_t> unit) {
  constexpr std::uint8_t kSei = 6, kUserData = 5;
  const auto bytes = payload(unit);
  if (bytes.size() < 2 || (bytes[0] & 31) != kSei || bytes[1] != kUserData) return {};
  std::size_t at = 2;
  while (at < bytes.size() && bytes[at] == 255) ++at;
  ++at;
  if (at + kX264Uuid.size() >= bytes.size()) return {};
  const auto message = bytes.subspan(at);
  if (!std::equal(kX264Uuid.begin(), kX264Uuid.end(), message.begin())) return {};
  return message.subspan(kX264Uuid.size());
}

std::string textOf(std::span<const std::uint8_t> note) {
  const auto end = std::find(note.begin(), note.end(), std::uint8_t{0});
  return {note.begin(), end};
}

}  // namespace

std::size_t removeEncoderNote(std::span<std::uint8_t> stream, std::string* note) {
  std::size_t kept = nextUnit(stream, 0);
  for (std::size_t begin = kept; begin < stream.size();) {
    const std::size_t end = nextUnit(stream, std::min(begin + kStartCode.size() + 1, stream.size()));
    const auto unit = stream.subspan(begin, end - begin);
    const auto found = noteOf(unit);
    if (!found.empty() && note != nullptr) *note = textOf(found);
    if (found.empty()) {
      std::memmove(stream.data() + kept, unit.data(), unit.size());
      kept += unit.size();
    }
    begin = end;
  }
  return kept;
}

}  // namespace poinsot::output
