// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <optional>
#include <stdexcept>
#include <string>

#include "core/abi.h"

namespace poinsot::core {

/// Category of an error. The command line maps each kind to one exit code.
enum class ErrorKind {
  kUsage,     ///< invalid command line (exit 2)
  kScene,     ///< invalid scene file, or invalid file that it names (exit 2)
  kLimit,     ///< exceeded limit (exit 2)
  kPhysics,   ///< quantity that does not exist for this body or initial motion (exit 2)
  kGraphics,  ///< failure of OpenGL or a back end (exit 3)
  kEncode,    ///< failure of the video encoder (exit 3)
  kIo,        ///< failure to read a file named on the command line, or to write output (exit 4)
};

/// Position in a file. Line and column count from 1; 0 means unknown.
struct SourceLocation {
  std::string file;
  int line = 0;
  int column = 0;
};

/// Returns "file:line:column" without the unknown parts.
std::string toString(const SourceLocation& where);

/// Exception for invalid input and for failures outside the program, such as a full disk. what() returns the
/// position in the file, if known, and the message. A bug inside the program throws std::logic_error instead
/// (expect.h).
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& message, std::optional<SourceLocation> where = std::nullopt);

  ErrorKind kind() const { return kind_; }
  const std::string& message() const { return message_; }
  const std::optional<SourceLocation>& where() const { return where_; }

 private:
  ErrorKind kind_;
  std::string message_;
  std::optional<SourceLocation> where_;
};

Error usageError(const std::string& message);
Error sceneError(const std::string& message);
Error limitError(const std::string& message);
Error physicsError(const std::string& message);
Error graphicsError(const std::string& message);
Error encodeError(const std::string& message);
Error ioError(const std::string& message);

/// Returns the system's message for an errno, such as "No space left on device".
std::string systemReason(int code);

/// Exception thrown when the reader of standard output has closed the pipe. The program then ends silently.
class BrokenPipe : public std::exception {};

}  // namespace poinsot::core
