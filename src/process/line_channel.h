// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/abi.h"

namespace poinsot::process {

/// Reader that splits a stream into lines. Does not own the descriptor.
class LineReader {
 public:
  explicit LineReader(int fd) : fd_(fd) {}

  /// Reads available data, or waits for data. Returns false at the end of the stream or after an error. For a
  /// pipe, both mean that the other process has ended.
  bool fill();
  /// Returns the next complete line in the buffer, without its newline, or nullopt.
  std::optional<std::string> take();
  /// Waits for the next line. Returns nullopt at the end of the stream or after an error.
  std::optional<std::string> wait();

 private:
  int fd_;
  std::string buffer_;
  std::size_t searched_ = 0;  // offset before which the buffer contains no newline
};

/// Writes the line and a newline. Returns false on failure, for example if the reader has ended.
bool writeLine(int fd, std::string_view line);

/// Writes the complete text. Returns 0 or an errno.
int writeText(int fd, std::string_view text);

}  // namespace poinsot::process
