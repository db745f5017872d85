// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/rational.h"
#include "image/image.h"
#include "job/render_request.h"
#include "output/film_format.h"

/// Search for the best film whose file is not larger than a limit. The search makes films and measures them. It
/// depends on nothing but the sizes of these files, so equal files give equal choices.
namespace poinsot::job {

/// Properties of a film that the search may change.
struct FilmChoice {
  image::PixelSize size = {};
  core::Rational fps = {};
  int colors = 0;  ///< colours in the palette of a GIF; unused in other films
  int crf = 0;     ///< rate factor of an MP4 or a WebM; unused in other films
  friend bool operator==(const FilmChoice&, const FilmChoice&) = default;
};

/// Properties that the user has fixed. The search does not change them.
struct FixedProperties {
  bool size = false, fps = false, colors = false, crf = false;
};

/// Returns all films that may replace the film `asked`, which comes first. No property is better than in `asked`.
/// The width is at least 320 pixels, and the rate at least 10 frames per second, unless `asked` has less. The
/// delays of a GIF's frames are whole hundredths of a second.
std::vector<FilmChoice> smallerFilms(const FilmChoice& asked, output::FilmContainer container,
                                     const FixedProperties& fixed);

/// Film to make next, and the sizes with which it ends the search.
struct SizeTrial {
  FilmChoice film;
  SizeRange_bytes accepted = {};
};

struct MeasuredFilm {
  FilmChoice film;
  std::int64_t bytes = 0;
};

/// Search that makes at most three trials, and then one more film: the best trial that fits, again, or the
/// smallest film. Use: make next(), and add() its size, until the size is accepted or next() returns nullopt.
///
/// The film as asked is the result if it fits. It is left out only if it cannot fit: a film with a quarter of the
/// pixels has at most half of the bytes, unless it is larger than the limit itself. Between the other films, the
/// search predicts the size from the films that it has measured.
class SizeSearch {
 public:
  SizeSearch(const FilmChoice& asked, output::FilmContainer container, const FixedProperties& fixed,
             std::int64_t most_bytes);

  /// Returns the next film to make. Returns nullopt if even the smallest film is too large.
  std::optional<SizeTrial> next() const;
  /// Adds the size of the film that next() returned.
  void add(std::int64_t bytes);

  /// Returns the smallest film that was made. @pre add() was called.
  const MeasuredFilm& smallest() const;

 private:
  struct Candidate {
    FilmChoice film;
    double shrink = 0;  ///< predicted logarithm of the factor by which the file is smaller than as asked
    double loss = 0;    ///< loss of quality, on a scale of its own
  };
  struct Measured {
    std::size_t candidate;
    MeasuredFilm film;
  };

  std::size_t probe() const;
  bool mayFitAsAsked() const;
  double predicted_bytes(const Candidate& film) const;
  double steepness() const;
  bool isMeasured(std::size_t candidate) const;
  const Measured* bestThatFits() const;
  std::optional<std::size_t> bestPredicted() const;
  std::size_t leastBytes() const;
  SizeTrial trial(std::size_t candidate, double least_bytes = 0) const;

  std::vector<Candidate> candidates_;  // the film as asked is the first
  std::vector<Measured> measured_;
  std::int64_t most_bytes_;
};

}  // namespace poinsot::job
