// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "core/error.h"

namespace poinsot::core {

/// All bytes of a regular file: no directory, and no pipe or device that might never end.
/// @throws Error(kind) "cannot read FILE: why"; Error(kLimit) if it has more than `mostBytes`.
std::string readRegularFile(const std::filesystem::path& path, std::size_t mostBytes, ErrorKind kind);

}  // namespace poinsot::core
