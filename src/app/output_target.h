// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace poinsot::app {

enum class OutputKind {
  kFilm,      ///< one .mp4
  kPicture,   ///< one .png of one frame
  kSequence,  ///< a .png per frame; the path is an output::FramePattern
};

/// Where the result goes.
struct OutputTarget {
  OutputKind kind = OutputKind::kFilm;
  std::filesystem::path path;
};

/// Reads the kind off the name.
/// @throws core::Error(kUsage) saying which names work.
OutputTarget parseTarget(const std::string& name);

}  // namespace poinsot::app
