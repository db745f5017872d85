// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "compare/changes.h"
#include "compare/difference.h"
#include "compare/picture_rule.h"
#include "core/file_batch.h"
#include "image/png_file.h"
#include "output/file_kind.h"
#include "scene/limits.h"

namespace poinsot::compare {

/// How pictures are compared, and what is written of it.
struct DiffRequest {
  PictureRule rule = {};
  double pixelsPerDegree = kFlipPixelsPerDegree;
  std::optional<std::filesystem::path> map = {};         ///< FLIP's, in the colours of magma
  std::optional<std::filesystem::path> difference = {};  ///< amplified
  scene::Limits limits = {};                             ///< of these the memory counts
};

/// A picture to be compared.
struct DiffPicture {
  image::AnyImage pixels;
  image::PngStorage stored = {};
  image::ColorTag color = {};
};

/// Where the frames of two films differ; the figures beside it are those of the worst frame.
struct FilmSummary {
  std::size_t frames = 0;
  std::size_t differing = 0;         ///< frames of the films' verdict
  std::size_t worst = 0, first = 0;  ///< numbers of frames, from 0: the worst, and the first of its verdict
  double worst_s = 0, first_s = 0;   ///< when they are shown
};

/// Result of comparing two pictures, or two films.
struct PictureDiff {
  std::string name;  ///< of the pair in a folder; empty for two files
  Verdict verdict = Verdict::kDifferent;
  std::string mismatch;     ///< "the size is 640x480, not 320x240"; empty where the two go together
  bool isReadable = true;   ///< whether both files could be read; else the mismatch says why not
  bool hasFigures = false;  ///< whether pixels were compared
  image::PixelSize size;    ///< of the reference; 0 where none could be read
  int channels = 3;         ///< of the reference, as stored
  ImageDifference figures;
  double beyond = 0;                      ///< compare::distanceBeyond() of the rule
  Changes changes;                        ///< where and how the pictures differ; empty where there are no figures
  std::vector<std::string> excesses;      ///< what of the rule does not hold
  double ignoredShare = 0;                ///< part of the picture that was not compared, 0 to 1
  std::vector<image::PixelRect> ignored;  ///< places that were not compared; a few hundred at most
  std::vector<std::string> notes;         ///< what is no difference of pixels: "grey beside RGB, same pixels"
  bool storedAlike = true;                ///< whether both files store their pixels in the same way
  std::optional<FilmSummary> film;        ///< of two films

  /// Whether the pair is good enough. @param exact  asks for identical pixels that are stored alike
  bool passes(bool exact) const {
    if (exact) return verdict == Verdict::kIdentical && storedAlike;
    return verdict != Verdict::kDifferent;
  }
};

/// Why a pair is not what it should be: the mismatch, what of the rule does not hold, and of films in which
/// frames; empty where nothing is wrong.
std::string reasonOf(const PictureDiff& diff);

/// Orders pairs: less is better. Of one verdict those without figures are the worst, then those farthest beyond
/// the limits, then counts FLIP's mean.
inline std::tuple<Verdict, bool, double, double> badness(const PictureDiff& diff) {
  return {diff.verdict, !diff.hasFigures, diff.beyond, diff.figures.flip.mean};
}

/// Two pictures beside what came of comparing them, from which maps are drawn.
struct ComparedPictures {
  DiffPicture reference, test;
  PictureDiff diff;
  FlipMap flip;  ///< empty where there are no figures
};

/// Compares by value and by the rule of the request; the pictures that come back are in a common form.
/// @throws core::Error(kLimit) if that takes more memory than it may; (kUsage) as ignoreMaskOf().
ComparedPictures comparePictures(DiffPicture reference, DiffPicture test, const DiffRequest& request);

/// The amplified difference of two pictures that have figures. @throws as ignoreMaskOf().
image::Image differenceOf(const ComparedPictures& compared, const DiffRequest& request);

/// Maps of this program: the pictures that a request asks for.
const output::FileKind& mapKind();

/// Removes the maps of an earlier run.
void forgetMaps(const DiffRequest& request);

/// Adds the maps that the request asks for to a batch. Where pictures have no figures, those of an earlier run are
/// removed. @throws core::Error(kIo) where something cannot be written.
void addMaps(core::FileBatch& batch, const ComparedPictures& compared, const DiffRequest& request);
/// Adds the removal of the maps of an earlier run.
void addRemovalOfMaps(core::FileBatch& batch, const DiffRequest& request);

/// Writes the maps of addMaps(). @throws core::Error(kIo) where something cannot be written.
void writeMaps(const ComparedPictures& compared, const DiffRequest& request);

}  // namespace poinsot::compare
