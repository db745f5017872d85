// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/picture_diff.h"
#include "core/rational.h"

namespace poinsot::app {

/// Two films, frame by frame.
struct FilmDiff {
  std::string mismatch;             ///< "the film has 89 frames, not 90"; empty where both go together
  core::Rational fps;               ///< of the reference
  std::vector<PictureDiff> frames;  ///< of as many as both have; named by their number

  /// The worst of the frames; different where the films do not go together.
  image::Verdict verdict() const;
  /// The frame that an eye notices most, by FLIP's mean. @pre there is one.
  std::size_t worst() const;
};

/// Compares every frame of two films, `jobs` at a time. Where the request names places for pictures these are
/// files, and get that of the worst frame.
/// @throws core::Error(kIo) with the film, if one cannot be read.
FilmDiff diffFilms(const std::filesystem::path& reference, const std::filesystem::path& test,
                   const DiffRequest& request, int jobs);

/// The figures over time: a line for each frame, CSV with a header.
std::string curveCsv(const FilmDiff& diff);

}  // namespace poinsot::app
