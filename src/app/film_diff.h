// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
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
  /// Of those of the worst verdict the one that an eye notices most, by FLIP's mean. @pre there is one.
  std::size_t worst() const;
  /// When it is shown; 0 where the film says no rate.
  double time_s(std::size_t frame) const { return fps.num == 0 ? 0 : static_cast<double>(frame) / fps.value(); }
};

/// Compares every frame of two films, `jobs` at a time. Where the request names places for pictures these are
/// files, and get that of the worst frame.
/// @throws core::Error(kIo) with the film, if one cannot be read.
FilmDiff diffFilms(const std::filesystem::path& reference, const std::filesystem::path& test,
                   const DiffRequest& request, int jobs);

/// Compares some frames of two such films again and hands them on with their pictures, since no film is kept in
/// memory. @param frames  rising. @throws as diffFilms.
void forFrames(const std::filesystem::path& reference, const std::filesystem::path& test,
               const std::vector<std::size_t>& frames, const DiffRequest& request,
               const std::function<void(std::size_t frame, const ComparedPictures&)>& visit);

}  // namespace poinsot::app
