// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "compare/film_times.h"
#include "compare/picture_diff.h"
#include "core/rational.h"

namespace poinsot::compare {

/// Comparison of two films, frame by frame.
struct FilmDiff {
  std::string mismatch;             ///< such as "the film has 89 frames, not 90"; empty if the films match
  core::Rational fps;               ///< frame rate of the reference
  FilmTimes times;                  ///< frame times of the reference
  std::vector<PictureDiff> frames;  ///< one for each frame that both films have; `name` is its number

  /// Returns the worst verdict of the frames, or kDifferent if there is a mismatch.
  Verdict verdict() const;
  /// Returns the frame with the largest badness(). @pre there is at least one frame.
  std::size_t worst() const;
  /// Returns the first frame that has the verdict of the worst frame. @pre there is at least one frame.
  std::size_t first() const;
  /// Returns when the reference shows a frame, in seconds after its first frame.
  double time_s(std::size_t frame) const { return times.start_s(frame); }
};

/// Compares every frame of two films and the times at which the frames are shown. Compares `jobs` frames at a
/// time, or fewer if the memory limit requires it.
/// @throws core::Error(kIo) with the film, if one cannot be read; (kLimit), before decoding, if pictures of this
///   size would exceed the memory limit
FilmDiff diffFilms(const std::filesystem::path& reference, const std::filesystem::path& test,
                   const DiffRequest& request, int jobs);

/// Returns the comparison of two films as if it were one pair, with the figures and the number of the worst frame.
PictureDiff summaryOf(const FilmDiff& diff);

/// Compares selected frames of two films again, and passes each result to `visit`. The films are read again,
/// because they are not kept in memory.
/// @param frames  frame numbers in rising order.
/// @throws core::Error as diffFilms()
void forFrames(const std::filesystem::path& reference, const std::filesystem::path& test,
               const std::vector<std::size_t>& frames, const DiffRequest& request,
               const std::function<void(std::size_t frame, const ComparedPictures&)>& visit);

}  // namespace poinsot::compare
