// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "core/abi.h"
#include "output/film_format.h"
#include "request/picture_options.h"
#include "scene/scene.h"

namespace poinsot::request {

enum class OutputKind {
  kFilm,      ///< one file in an output::FilmContainer
  kPicture,   ///< one .png of one frame
  kSequence,  ///< one .png per frame; the path is an output::FramePattern
  kFigure,    ///< one frame in vectors and type, in a figure::FigureMedium
};

struct OutputTarget {
  OutputKind kind = OutputKind::kFilm;
  std::filesystem::path path;
  bool stream = false;  ///< writes to standard output as it is made; `path` then only locates intermediate parts
};

/// Returns whether the target can hold pictures of 16 bits per sample, as PNG files can.
bool takesDeepPictures(const OutputTarget& target);

/// Parses the name of a render's output; its extension and {frame} pattern select the kind.
/// @throws core::Error(kUsage) for an unusable name, listing the names that work.
OutputTarget parseTarget(const std::string& name);

/// Returns the target for standard output.
/// @param format  "png" (pictures one after the other) or "mp4"
/// @throws core::Error(kUsage) for another format.
OutputTarget streamTarget(const std::string& format);

/// Parses the name of a still's output, a picture or a figure.
/// @throws core::Error(kUsage) for an unusable name, listing the names that work.
OutputTarget parseStillTarget(const std::string& name);

/// Returns the film format for a target: the scene's choices, else the defaults of the file's container.
output::FilmFormat filmFormat(const OutputTarget& target, const scene::Output& asked, const PictureOptions& form);

}  // namespace poinsot::request
