// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/abi.h"

namespace poinsot::process {

/// Splits a stream into lines. Does not own the descriptor.
class LineReader {
 public:
  explicit LineReader(int fd) : fd_(fd) {}

  /// Reads once, waiting for data. Returns false at the end of the stream, and on an error, which for a pipe means
  /// the same: the other side is gone.
  bool fill();
  /// Returns the next line that is complete in the buffer, without its newline.
  std::optional<std::string> take();
  /// Waits for the next line. Returns nullopt at the end of the stream.
  std::optional<std::string> wait();

 private:
  int fd_;
  std::string buffer_;
  std::size_t searched_ = 0;  // the buffer has no newline before this offset
};

/// Writes the line and a newline. Returns false on an error, such as a reader that is gone.
bool writeLine(int fd, std::string_view line);

/// Writes the whole text. Returns 0 or an errno.
int writeText(int fd, std::string_view text);

}  // namespace poinsot::process
