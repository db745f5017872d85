// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace poinsot::core {

/// Returns the absolute path of this program's file. Without /proc, resolves the path by which the program was
/// called. Returns an empty path on failure.
std::filesystem::path programPath();

}  // namespace poinsot::core
