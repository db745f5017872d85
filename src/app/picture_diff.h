// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "image/difference.h"
#include "image/near_rule.h"
#include "scene/limits.h"

namespace poinsot::app {

/// How pictures are compared, and what is written of it.
struct DiffRequest {
  image::NearRule rule;
  double pixelsPerDegree = image::kFlipPixelsPerDegree;
  std::optional<std::filesystem::path> map = {};         ///< FLIP's, in the colours of magma
  std::optional<std::filesystem::path> difference = {};  ///< amplified
  scene::Limits limits = {};                             ///< of these the memory counts
};

/// A picture to be compared.
struct DiffPicture {
  image::AnyImage pixels;
  int channels = 3;  ///< as its file has them
};

/// What came of comparing two pictures.
struct PictureDiff {
  std::string name;  ///< of the pair in a folder; empty for two files
  image::Verdict verdict = image::Verdict::kDifferent;
  std::string mismatch;   ///< why there are no figures: "the size is 640x480, not 320x240"; empty where there are
  image::PixelSize size;  ///< of the reference
  int channels = 3;
  image::ImageDifference figures;
  std::vector<std::string> excesses;  ///< what of the rule does not hold
};

/// Why a pair is not what it should be: the mismatch, or what of the rule does not hold; empty where nothing is
/// wrong.
std::string reasonOf(const PictureDiff& diff);

/// Orders pairs: less is better. Of one verdict those without figures are the worst, then counts FLIP's mean.
inline std::tuple<image::Verdict, bool, double> badness(const PictureDiff& diff) {
  return {diff.verdict, !diff.mismatch.empty(), diff.figures.flip.mean};
}

/// Two pictures beside what came of comparing them, from which maps are drawn.
struct ComparedPictures {
  DiffPicture reference, test;
  PictureDiff diff;
  image::FlipMap flip;  ///< empty where there are no figures
};

/// Compares by the rule of the request. @throws core::Error(kLimit) if that takes more memory than it may.
ComparedPictures comparePictures(DiffPicture reference, DiffPicture test, const DiffRequest& request);
/// Two PNG files. @throws core::Error(kIo) with the file, if one cannot be read.
ComparedPictures compareFiles(const std::filesystem::path& reference, const std::filesystem::path& test,
                              const DiffRequest& request);

/// Removes what an earlier run wrote where the request asks for maps.
void forgetMaps(const DiffRequest& request);

/// Writes what the request asks for; of pictures that have no figures nothing, and removes what an earlier run
/// wrote.
/// @throws core::Error(kIo) where something cannot be written.
void writeMaps(const ComparedPictures& compared, const DiffRequest& request);

}  // namespace poinsot::app
