// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace poinsot::app {

enum class OutputKind {
  kFilm,      ///< one file of an output::FilmContainer
  kPicture,   ///< one .png of one frame
  kSequence,  ///< a .png per frame; the path is an output::FramePattern
  kFigure,    ///< of one frame, with vectors and type: one of output::FigureMedium
};

/// Where the result goes.
struct OutputTarget {
  OutputKind kind = OutputKind::kFilm;
  std::filesystem::path path;
};

/// Of a film: reads the kind off the name.
/// @throws core::Error(kUsage) saying which names work.
OutputTarget parseTarget(const std::string& name);

/// Of a still: a picture or a figure.
/// @throws core::Error(kUsage) saying which names work.
OutputTarget parseStillTarget(const std::string& name);

}  // namespace poinsot::app
