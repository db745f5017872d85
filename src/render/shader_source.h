// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace poinsot::render {

/// Text of a file of shaders/, its #include "..." lines replaced by those files, after `defines`. Embedded at
/// build time; POINSOT_SHADERS=folder in the environment reads that folder instead, for live editing.
/// @throws core::Error(kGraphics) for an unknown file.
std::string shaderSource(const std::string& file, const std::string& defines = "");

}  // namespace poinsot::render
