// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace poinsot::core {

/// Returns the absolute path of this program's file. Without /proc, resolves the path by which the program was
/// called. Returns an empty path on failure.
std::filesystem::path programPath();

/// Returns the folder of the libraries that are installed with this program, such as PREFIX/lib/poinsot for
/// PREFIX/bin/poinsot. It exists only in a portable package (packaging/portable).
std::filesystem::path ownLibraries();

}  // namespace poinsot::core
