// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "compare/picture_diff.h"
#include "core/error.h"

namespace poinsot::compare {

/// Compares two PNG files, or two films by all their frames; an animated PNG is a film, whatever its name. Of
/// films the pictures are those of the worst frame, and none where all frames are identical.
/// @param jobs  frames at a time
/// @throws core::Error(kIo) with the file, if one cannot be read; as comparePictures().
ComparedPictures compareFiles(const std::filesystem::path& reference, const std::filesystem::path& test,
                              const DiffRequest& request, int jobs = 1);

/// The result of a pair that cannot be compared because of an error.
PictureDiff unreadablePair(const core::Error& error);

}  // namespace poinsot::compare
