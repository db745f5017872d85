// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/picture_diff.h"
#include "core/error.h"

namespace poinsot::app {

/// Many pairs, and what had no partner.
struct FolderDiff {
  std::vector<PictureDiff> pictures;  ///< by name
  std::vector<std::string> onlyInReference, onlyInTest;
  std::vector<std::string> linkedFolders;  ///< links to folders, which are not followed
  std::optional<core::Error> firstError;   ///< of the first pair that could not be read or drawn; it is different

  /// The worst of the pairs; different where something has no partner.
  image::Verdict verdict() const;
};

/// Pairs the PNG files of two folders and the folders in them by their names and compares each pair; `jobs` at a
/// time. Where the request names places for pictures these are folders, and get one of each pair that is not
/// identical, by its name.
/// @throws core::Error(kIo) with a folder that cannot be read; (kUsage) if neither has a PNG or a film.
FolderDiff diffFolders(const std::filesystem::path& reference, const std::filesystem::path& test,
                       const DiffRequest& request, int jobs);

}  // namespace poinsot::app
