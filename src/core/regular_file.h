// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "core/error.h"
#include "core/file_handle.h"

namespace poinsot::core {

/// Opens a file for reading, without waiting for the writer of a pipe. Returns an empty handle, with errno set, on
/// failure.
FileHandle openForReading(const std::filesystem::path& path);

/// Reads an open regular file from its current position. Stops after `mostBytes` + 1 bytes: a result of that
/// length shows that the file is too large. Rejects directories, pipes and devices.
/// @throws Error(kind) with the reason only. If a system call fails, or the handle is empty, throws a FileError
/// with errno and without a file name.
std::string bytesOf(const FileHandle& file, std::size_t mostBytes, ErrorKind kind);

/// Reads an open regular file of at most `mostBytes` bytes. Reads nothing if the reported size is larger.
/// @throws Error(kind) as bytesOf(); Error(kLimit) "it has N bytes, more than the allowed M".
std::string allBytesOf(const FileHandle& file, std::size_t mostBytes, ErrorKind kind);

/// Reads all bytes of a regular file.
/// @throws FileError(kind) "cannot read FILE: REASON"; FileError(kLimit) with the same text if the file has more
/// than `mostBytes`.
std::string readRegularFile(const std::filesystem::path& path, std::size_t mostBytes, ErrorKind kind);

}  // namespace poinsot::core
