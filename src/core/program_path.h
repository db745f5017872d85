// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace poinsot::core {

/// This program's file, absolute. Where /proc is not mounted, by how it was called; empty if that leads nowhere.
std::filesystem::path programPath();

}  // namespace poinsot::core
