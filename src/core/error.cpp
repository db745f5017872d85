// SPDX-License-Identifier: Apache-2.0
#include "core/error.h"

#include <system_error>

#include <fmt/format.h>

namespace poinsot::core {

std::string toString(const SourceLocation& where) {
  if (where.line == 0) return where.file;
  if (where.column == 0) return fmt::format("{}:{}", where.file, where.line);
  return fmt::format("{}:{}:{}", where.file, where.line, where.column);
}

Error::Error(ErrorKind kind, const std::string& message, std::optional<SourceLocation> where)
    : std::runtime_error(where ? toString(*where) + ": " + message : message),
      kind_(kind),
      message_(message),
      where_(std::move(where)) {}

Error usageError(const std::string& message) { return {ErrorKind::kUsage, message}; }
Error sceneError(const std::string& message) { return {ErrorKind::kScene, message}; }
Error limitError(const std::string& message) { return {ErrorKind::kLimit, message}; }
Error physicsError(const std::string& message) { return {ErrorKind::kPhysics, message}; }
Error graphicsError(const std::string& message) { return {ErrorKind::kGraphics, message}; }
Error encodeError(const std::string& message) { return {ErrorKind::kEncode, message}; }
Error ioError(const std::string& message) { return {ErrorKind::kIo, message}; }

std::string systemReason(int code) { return std::generic_category().message(code); }

}  // namespace poinsot::core
