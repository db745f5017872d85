// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace poinsot::core {

/// How this program's file was called when it started: a path, good as long as the working folder is the same.
/// Safe between fork and exec.
const char* programAsCalled() noexcept;

/// This program's file, absolute. Where /proc is not mounted, by how it was called; empty if that leads nowhere.
std::filesystem::path programPath();

}  // namespace poinsot::core
