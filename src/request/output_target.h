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
  kFilm,      ///< one file of an output::FilmContainer
  kPicture,   ///< one .png of one frame
  kSequence,  ///< a .png per frame; the path is an output::FramePattern
  kFigure,    ///< of one frame, with vectors and type: one of figure::FigureMedium
};

/// Where the result goes.
struct OutputTarget {
  OutputKind kind = OutputKind::kFilm;
  std::filesystem::path path;
  bool stream = false;  ///< to standard output while it is made; `path` is then only where the parts lie
};

/// Whether pictures of 16 bits a sample can go there: PNG.
bool takesDeepPictures(const OutputTarget& target);

/// Of a film: reads the kind off the name.
/// @throws core::Error(kUsage) saying which names work.
OutputTarget parseTarget(const std::string& name);

/// Of standard output: "png", pictures one after the other, or "mp4".
/// @throws core::Error(kUsage) for another format.
OutputTarget streamTarget(const std::string& format);

/// Of a still: a picture or a figure.
/// @throws core::Error(kUsage) saying which names work.
OutputTarget parseStillTarget(const std::string& name);

/// How a film of that name is made: what the scene asks for, and else what its kind of file usually holds.
output::FilmFormat filmFormat(const OutputTarget& target, const scene::Output& asked, const PictureOptions& form);

}  // namespace poinsot::request
