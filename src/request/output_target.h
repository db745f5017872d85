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
  kFilm,      ///< one film file in an output::FilmContainer
  kPicture,   ///< one frame as a .png file
  kSequence,  ///< one .png file per frame; `path` is an output::FramePattern
  kFigure,    ///< one frame with vectors and letters, in a figure::FigureMedium
};

struct OutputTarget {
  OutputKind kind = OutputKind::kFilm;
  std::filesystem::path path;
  bool stream = false;  ///< writes to standard output; `path` then only locates temporary parts
};

/// Returns whether the output can have 16 bits per sample. Only PNG files can.
bool takesDeepPictures(const OutputTarget& target);

/// Parses the file name of the command `render`. The extension and a {frame} pattern decide whether the output is
/// a film, a picture or a sequence.
/// @throws core::Error(kUsage) if the name is not allowed, listing the allowed names.
OutputTarget parseTarget(const std::string& name);

/// Returns the target for standard output.
/// @param format  "png" for pictures one after the other, or "mp4"
/// @throws core::Error(kUsage) for another format.
OutputTarget streamTarget(const std::string& format);

/// Parses the file name of the command `still`. The output is a picture or a figure.
/// @throws core::Error(kUsage) if the name is not allowed, listing the allowed names.
OutputTarget parseStillTarget(const std::string& name);

/// Returns the format of a film. A property that the scene does not choose is the default of the film's container.
output::FilmFormat filmFormat(const OutputTarget& target, const scene::Output& asked, const PictureOptions& form);

}  // namespace poinsot::request
