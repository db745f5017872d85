// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/picture_diff.h"
#include "core/error.h"

namespace poinsot::compare {

/// Names of the PNG files and films in two folders and the folders in them, sorted.
struct FolderNames {
  std::vector<std::string> inBoth, onlyInReference, onlyInTest;
  std::vector<std::string> linkedFolders;  ///< links to folders, which are not followed
};

/// @throws core::Error(kIo) with a folder that cannot be read; (kUsage) if neither has a PNG or a film.
FolderNames namesInFolders(const std::filesystem::path& reference, const std::filesystem::path& test);

/// The request for one pair of two folders, where the places for pictures are folders, too.
DiffRequest requestForPair(const DiffRequest& request, const std::string& name);

/// Many pairs, and what had no partner.
struct FolderDiff {
  FolderNames names;
  std::vector<PictureDiff> pictures;      ///< of the pairs, by name
  std::optional<core::Error> firstError;  ///< of the first pair that could not be read or drawn; it is different

  /// The worst of the pairs; different where something has no partner.
  Verdict verdict() const;
};

/// Compares each pair of two folders; `jobs` at a time. Where the request names places for pictures these are
/// folders, and get one of each pair that is not identical, by its name.
/// @param maps  gets these pictures, and the removal of those that an earlier run wrote for identical pairs
FolderDiff diffFolders(const std::filesystem::path& reference, const std::filesystem::path& test,
                       FolderNames names, const DiffRequest& request, int jobs, core::FileBatch& maps);

}  // namespace poinsot::compare
