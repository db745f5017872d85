// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <optional>
#include <stdexcept>
#include <string>

#include "core/abi.h"

namespace poinsot::core {

/// What failed, in the caller's terms; the command line maps each kind to one exit code.
enum class ErrorKind {
  kUsage,     ///< the command line (exit 2)
  kScene,     ///< the scene file or a file it names (exit 2)
  kLimit,     ///< a printed limit was exceeded (exit 2)
  kPhysics,   ///< a quantity that does not exist for this body or start (exit 2)
  kGraphics,  ///< OpenGL, back ends (exit 3)
  kEncode,    ///< the video encoder (exit 3)
  kIo,        ///< files named on the command line, output (exit 4)
};

/// A place in a file; line and column count from 1, 0 is unknown.
struct SourceLocation {
  std::string file;
  int line = 0;
  int column = 0;
};

/// "file:line:column", leaving out what is unknown.
std::string toString(const SourceLocation& where);

/// What goes from layer to layer when bad input, or something outside the program, makes it fail. A broken
/// contract inside the program is std::logic_error instead (expect.h).
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

/// Make an error of a kind, to be thrown.
Error usageError(const std::string& message);
Error sceneError(const std::string& message);
Error limitError(const std::string& message);
Error physicsError(const std::string& message);
Error graphicsError(const std::string& message);
Error encodeError(const std::string& message);
Error ioError(const std::string& message);

/// Returns the system's words for an errno: "No space left on device".
std::string systemReason(int code);

/// The reader of standard output is gone: nothing is left to do, and nothing to say.
class BrokenPipe : public std::exception {};

}  // namespace poinsot::core
