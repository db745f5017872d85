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

/// Options of a comparison, and the maps to write.
struct DiffRequest {
  PictureRule rule = {};
  double pixelsPerDegree = kFlipPixelsPerDegree;
  std::optional<std::filesystem::path> map = {};         ///< file for FLIP's map, in the colours of magma
  std::optional<std::filesystem::path> difference = {};  ///< file for the amplified difference
  scene::Limits limits = {};                             ///< limits; only the memory limit is used
};

struct DiffPicture {
  image::AnyImage pixels;
  image::PngStorage stored = {};
  image::ColorTag color = {};
};

/// Summary of a film's differing frames. The figures of PictureDiff then refer to the worst frame.
struct FilmSummary {
  std::size_t frames = 0;
  std::size_t differing = 0;         ///< number of frames with the worst frame's verdict
  std::size_t worst = 0, first = 0;  ///< numbers of the worst frame and of the first with its verdict
  double worst_s = 0, first_s = 0;   ///< times of these two frames in the film, in seconds
};

/// Result of comparing two pictures or two films.
struct PictureDiff {
  std::string name;  ///< name of a pair from two folders; empty for two files
  Verdict verdict = Verdict::kDifferent;
  std::string mismatch;     ///< such as "the size is 640x480, not 320x240"; empty if they match
  bool isReadable = true;   ///< whether both files could be read; if not, `mismatch` has the error
  bool hasFigures = false;  ///< whether pixels were compared
  image::PixelSize size;    ///< size of the reference; 0 if nothing could be read
  int channels = 3;         ///< channels of the reference, as stored
  ImageDifference figures;
  double beyond = 0;                      ///< by how much the rule is exceeded, see distanceBeyond()
  Changes changes;                        ///< places and kinds of the differences; empty without figures
  std::vector<std::string> excesses;      ///< descriptions of the exceeded limits
  double ignoredShare = 0;                ///< fraction of the picture that was not compared, 0 to 1
  std::vector<image::PixelRect> ignored;  ///< boxes that were not compared, at most a few hundred
  std::vector<std::string> notes;         ///< remarks, such as "stored as grey instead of RGB, same pixels"
  bool storedAlike = true;                ///< whether both files have the same storage format
  std::optional<FilmSummary> film;

  /// Reports whether the pair passes. @param exact  whether to require identical pixels in the same storage format
  bool passes(bool exact) const {
    if (exact) return verdict == Verdict::kIdentical && storedAlike;
    return verdict != Verdict::kDifferent;
  }
};

/// Returns why a pair is near or different: the mismatch and the exceeded limits, with the frame numbers of films.
/// Empty if there is neither.
std::string reasonOf(const PictureDiff& diff);

/// Returns a key for sorting pairs; a worse pair has a greater key. Among pairs with equal verdicts, pairs without
/// figures are the worst, then the pairs farthest beyond the limits. The mean FLIP error decides ties.
inline std::tuple<Verdict, bool, double, double> badness(const PictureDiff& diff) {
  return {diff.verdict, !diff.hasFigures, diff.beyond, diff.figures.flip.mean};
}

/// Two pictures with the result of their comparison, from which maps are drawn.
struct ComparedPictures {
  DiffPicture reference, test;
  PictureDiff diff;
  FlipMap flip;  ///< map of FLIP's error; empty if there are no figures
};

/// Compares the pixel values of two pictures and applies the request's rule. Returns the pictures in a common
/// form.
/// @throws core::Error(kLimit) if the comparison would exceed the memory limit; (kUsage) as ignoreMaskOf()
ComparedPictures comparePictures(DiffPicture reference, DiffPicture test, const DiffRequest& request);

/// Returns a picture of the amplified difference. Call only if the comparison has figures.
/// @throws core::Error as ignoreMaskOf()
image::Image differenceOf(const ComparedPictures& compared, const DiffRequest& request);

/// Returns the file kind of the maps that this program writes. A text in the PNG identifies a map.
const output::FileKind& mapKind();

void forgetMaps(const DiffRequest& request);

/// Adds the requested maps to a batch. If there are no figures, adds the removal of earlier maps instead.
/// @throws core::Error(kIo) if a file cannot be written
void addMaps(core::FileBatch& batch, const ComparedPictures& compared, const DiffRequest& request);
void addRemovalOfMaps(core::FileBatch& batch, const DiffRequest& request);

/// Writes the requested maps. If there are no figures, removes earlier maps instead.
/// @throws core::Error(kIo) if a file cannot be written
void writeMaps(const ComparedPictures& compared, const DiffRequest& request);

}  // namespace poinsot::compare
