// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "compare/film_diff.h"
#include "compare/folder_diff.h"
#include "compare/outcome.h"
#include "compare/picture_diff.h"

namespace poinsot::compare {

/// Names of the compared files or folders, as given on the command line.
struct DiffNames {
  std::string reference, test;
};

/// Returns a comparison as a JSON object. Undefined figures are null, such as the SSIM of pictures smaller than
/// 11x11, the PSNR of identical pictures, and all figures of pictures of different shape.
std::string diffJson(const PictureDiff& diff, const DiffNames& names, const DiffRequest& request);
std::string diffJson(const std::vector<Outcome>& outcomes, const DiffNames& names, const DiffRequest& request);
std::string diffJson(const FilmDiff& diff, const DiffNames& names, const DiffRequest& request);
/// Returns the outcomes of a suite as a JSON object, in the form of a comparison of two folders. Each picture also
/// has its files, limits and origins.
std::string suiteJson(const std::vector<Outcome>& outcomes, const DiffNames& names);

}  // namespace poinsot::compare
