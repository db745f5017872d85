// SPDX-License-Identifier: Apache-2.0
#include "process/line_channel.h"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>

#include "core/atomic_file.h"

namespace poinsot::process {

bool LineReader::fill() {
  std::array<char, 1 << 16> chunk;
  ssize_t got = 0;
  do got = read(fd_, chunk.data(), chunk.size());
  while (got < 0 && errno == EINTR);
  if (got <= 0) return false;
  buffer_.append(chunk.data(), static_cast<std::size_t>(got));
  return true;
}

std::optional<std::string> LineReader::take() {
  const auto end = buffer_.find('\n', searched_);
  if (end == std::string::npos) {
    searched_ = buffer_.size();
    return std::nullopt;
  }
  std::string line = buffer_.substr(0, end);
  buffer_.erase(0, end + 1);
  searched_ = 0;
  return line;
}

std::optional<std::string> LineReader::wait() {
  for (;;) {
    if (auto line = take()) return line;
    if (!fill()) return std::nullopt;
  }
}

bool writeLine(int fd, std::string_view line) { return writeText(fd, std::string(line) + "\n") == 0; }

int writeText(int fd, std::string_view text) {
  return core::writeAll(fd, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace poinsot::process
