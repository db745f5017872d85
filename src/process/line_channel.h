// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/abi.h"

namespace poinsot::process {

/// Cuts a stream into lines. Does not own the descriptor.
class LineReader {
 public:
  explicit LineReader(int fd) : fd_(fd) {}

  /// Reads once, waiting if nothing is there; false at the end of the stream (and on an error, which for a pipe
  /// means the same: the other side is gone).
  bool fill();
  /// The next whole line among what was read, without its newline.
  std::optional<std::string> take();
  /// The next line, waiting for it; empty at the end of the stream.
  std::optional<std::string> wait();

 private:
  int fd_;
  std::string buffer_;
  std::size_t searched_ = 0;  // no newline before this
};

/// Writes the line and a newline; false when the other side is gone.
bool writeLine(int fd, std::string_view line);

/// Writes all of it; 0, or the errno that stopped it.
int writeText(int fd, std::string_view text);

}  // namespace poinsot::process
