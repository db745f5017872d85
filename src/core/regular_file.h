// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "core/error.h"
#include "core/file_handle.h"

/// Reading whole files that come from anywhere.
namespace poinsot::core {

/// For reading; does not wait for the writer of a pipe. Empty where it cannot be opened, and errno says why.
FileHandle openForReading(const std::filesystem::path& path);

/// From where an open regular file stands (no directory, and no pipe or device that might never end) to its end:
/// at most one byte more than `mostBytes`, which is enough to refuse it.
/// @throws Error(kind) saying only why, a FileError without a name if the system refuses. An empty handle is
/// errno's reason.
std::string bytesOf(const FileHandle& file, std::size_t mostBytes, ErrorKind kind);

/// All of them, if they are not more than `mostBytes`: a file that says so itself is not read.
/// @throws Error(kind) as bytesOf(); Error(kLimit) "it has N bytes, more than the M that are read".
std::string allBytesOf(const FileHandle& file, std::size_t mostBytes, ErrorKind kind);

/// All bytes of a regular file.
/// @throws FileError(kind) "cannot read FILE: why"; FileError(kLimit) likewise, if it has more than `mostBytes`.
std::string readRegularFile(const std::filesystem::path& path, std::size_t mostBytes, ErrorKind kind);

}  // namespace poinsot::core
