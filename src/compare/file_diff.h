// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "compare/picture_diff.h"
#include "core/error.h"

namespace poinsot::compare {

/// Compares two PNG files, or all frames of two films. An animated PNG is a film, even with the extension .png.
/// For films, the returned pictures are those of the worst frame, or empty if all frames are identical.
/// @param jobs  number of frames to compare at a time
/// @throws core::Error(kIo) with the file, if one cannot be read; otherwise as comparePictures()
ComparedPictures compareFiles(const std::filesystem::path& reference, const std::filesystem::path& test,
                              const DiffRequest& request, int jobs = 1);

PictureDiff unreadablePair(const core::Error& error);

}  // namespace poinsot::compare
