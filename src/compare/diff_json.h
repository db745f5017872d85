// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "compare/film_diff.h"
#include "compare/folder_diff.h"
#include "compare/outcome.h"
#include "compare/picture_diff.h"

namespace poinsot::compare {

/// What was compared with what, as it was named.
struct DiffNames {
  std::string reference, test;
};

/// For programs: one JSON object. A figure that is not defined (SSIM below its window, PSNR of identical pictures,
/// all of pictures of different shape) is null.
std::string diffJson(const PictureDiff& diff, const DiffNames& names, const DiffRequest& request);
/// Pairs of two folders, and files without a partner.
std::string diffJson(const std::vector<Outcome>& outcomes, const DiffNames& names, const DiffRequest& request);
std::string diffJson(const FilmDiff& diff, const DiffNames& names, const DiffRequest& request);
/// A suite: as of two folders, and of each picture also its files, its limits and what made it.
std::string suiteJson(const std::vector<Outcome>& outcomes, const DiffNames& names);

}  // namespace poinsot::compare
