// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace poinsot::render {

/// Returns the text of a shader: `defines`, then the file from shaders/ with each #include "..." line replaced by
/// the included file. The files are embedded at build time. If the environment variable POINSOT_SHADERS names a
/// folder, files are read from that folder instead, so that shaders can be edited without a build.
/// @throws core::Error(kGraphics) for an unknown file.
std::string shaderSource(const std::string& file, const std::string& defines = "");

}  // namespace poinsot::render
