// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "compare/film_times.h"
#include "compare/picture_diff.h"
#include "core/rational.h"

namespace poinsot::compare {

/// Two films, frame by frame.
struct FilmDiff {
  std::string mismatch;             ///< "the film has 89 frames, not 90"; empty where both go together
  core::Rational fps;               ///< of the reference
  FilmTimes times;                  ///< of the reference
  std::vector<PictureDiff> frames;  ///< of as many as both have; named by their number

  /// The worst of the frames; different where the films do not go together.
  Verdict verdict() const;
  /// The frame with the largest badness(). @pre there is one.
  std::size_t worst() const;
  /// The first frame of the worst verdict. @pre there is one.
  std::size_t first() const;
  /// When the reference shows a frame, from its first.
  double time_s(std::size_t frame) const { return times.start_s(frame); }
};

/// Compares every frame of two films and the times at which they are shown: `jobs` frames at a time, or as many as
/// the limits leave memory for.
/// @throws core::Error(kIo) with the film, if one cannot be read; (kLimit) before a picture is decoded, if its
/// size takes more memory than it may.
FilmDiff diffFilms(const std::filesystem::path& reference, const std::filesystem::path& test,
                   const DiffRequest& request, int jobs);

/// The films as one pair: figures of the worst frame, and where it is.
PictureDiff summaryOf(const FilmDiff& diff);

/// Compares some frames of two such films again and hands them on with their pictures, since no film is kept in
/// memory. @param frames  rising. @throws as diffFilms.
void forFrames(const std::filesystem::path& reference, const std::filesystem::path& test,
               const std::vector<std::size_t>& frames, const DiffRequest& request,
               const std::function<void(std::size_t frame, const ComparedPictures&)>& visit);

}  // namespace poinsot::compare
