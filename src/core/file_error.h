// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "core/abi.h"
#include "core/error.h"

namespace poinsot::core {

/// Failure to read or write a file. Keeps the errno for callers that need it.
class FileError : public Error {
 public:
  /// @param code  errno of the failed system call; 0 if the content of the file is invalid
  FileError(ErrorKind kind, const std::string& message, std::filesystem::path file, int code,
            std::optional<SourceLocation> where = std::nullopt)
      : Error(kind, message, std::move(where)), file_(std::move(file)), code_(code) {}

  const std::filesystem::path& file() const { return file_; }
  int code() const { return code_; }

 private:
  std::filesystem::path file_;
  int code_;
};

/// Returns the errno of a FileError, and 0 for other errors. Lets a caller change the message and keep the errno.
inline int codeOf(const Error& error) {
  const auto* file = dynamic_cast<const FileError*>(&error);
  return file != nullptr ? file->code() : 0;
}

}  // namespace poinsot::core
