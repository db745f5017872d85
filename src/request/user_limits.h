// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "scene/limits.h"

namespace poinsot::request {

/// Where a user keeps limits of his own: userFile() of the name limits.toml.
std::filesystem::path userLimitsFile();

/// The usual limits with those of a file above them: keys are names of limits, values whole numbers or sizes as
/// text. A file that is not there changes nothing.
/// @throws scene::SceneErrors with all that is wrong in it and where; core::Error(kIo) if it cannot be read.
scene::Limits limitsOf(const std::filesystem::path& file);

}  // namespace poinsot::request
