// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace poinsot::render {

/// Returns the text of a file of shaders/ after `defines`, with its #include "..." lines replaced by those files.
/// Files are embedded at build time. If POINSOT_SHADERS names a folder in the environment, they are read from
/// there, for live editing.
/// @throws core::Error(kGraphics) for an unknown file.
std::string shaderSource(const std::string& file, const std::string& defines = "");

}  // namespace poinsot::render
