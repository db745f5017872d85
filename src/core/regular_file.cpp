// SPDX-License-Identifier: Apache-2.0
#include "core/regular_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "core/file_error.h"
#include "core/text.h"

namespace poinsot::core {
namespace {

[[noreturn]] void failByErrno(ErrorKind kind) {
  const int code = errno;
  throw FileError(kind, systemReason(code), {}, code);
}

/// Returns the size of a regular file in bytes. Throws an error for other kinds of files.
std::size_t expectRegular(const FileHandle& file, ErrorKind kind) {
  struct stat status {};
  if (!file || ::fstat(file.get(), &status) != 0) failByErrno(kind);
  if (S_ISDIR(status.st_mode)) throw FileError(kind, "it is a directory", {}, EISDIR);
  if (!S_ISREG(status.st_mode)) throw Error(kind, "it is not a regular file");
  return static_cast<std::size_t>(status.st_size);
}

[[noreturn]] void refuseSize(std::size_t bytes, std::size_t mostBytes) {
  throw limitError(fmt::format("it has {} bytes, more than the allowed {}", bytes, mostBytes));
}

}  // namespace

FileHandle openForReading(const std::filesystem::path& path) {
  return FileHandle(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
}

std::string bytesOf(const FileHandle& file, std::size_t mostBytes, ErrorKind kind) {
  expectRegular(file, kind);
  std::string bytes;
  char buffer[1 << 16];
  while (bytes.size() <= mostBytes) {
    const std::size_t wanted = std::min(sizeof buffer, mostBytes + 1 - bytes.size());
    const ssize_t count = ::read(file.get(), buffer, wanted);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) failByErrno(kind);
    if (count == 0) break;
    bytes.append(buffer, static_cast<std::size_t>(count));
  }
  return bytes;
}

std::string allBytesOf(const FileHandle& file, std::size_t mostBytes, ErrorKind kind) {
  if (const std::size_t said = expectRegular(file, kind); said > mostBytes) refuseSize(said, mostBytes);
  std::string bytes = bytesOf(file, mostBytes, kind);
  if (bytes.size() > mostBytes) refuseSize(bytes.size(), mostBytes);  // the file grew, or is in /proc
  return bytes;
}

std::string readRegularFile(const std::filesystem::path& path, std::size_t mostBytes, ErrorKind kind) {
  try {
    return allBytesOf(openForReading(path), mostBytes, kind);
  } catch (const Error& error) {
    throw FileError(error.kind(), fmt::format("cannot read {}: {}", printable(path.string()), error.message()),
                    path, codeOf(error));
  }
}

}  // namespace poinsot::core
