// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/picture_diff.h"
#include "core/error.h"

namespace poinsot::compare {

/// Paths of the PNG files and films in two folders and their subfolders, sorted.
struct FolderNames {
  std::vector<std::string> inBoth, onlyInReference, onlyInTest;
  std::vector<std::string> linkedFolders;  ///< links to folders, which are not followed
};

/// Finds the PNG files and films of two folders.
/// @throws core::Error(kIo) with a folder that cannot be read; (kUsage) if neither folder has a PNG file or a film
FolderNames namesInFolders(const std::filesystem::path& reference, const std::filesystem::path& test);

/// Returns the request for one pair of files from two folders. The pair's name is appended to the map folders of
/// `request`.
DiffRequest requestForPair(const DiffRequest& request, const std::string& name);

struct FolderDiff {
  FolderNames names;
  std::vector<PictureDiff> pictures;
  std::optional<core::Error> firstError;  ///< error of the first pair that could not be compared

  /// Returns the worst verdict of the pairs, or kDifferent if a file has no partner.
  Verdict verdict() const;
};

/// Compares all pairs of files that have the same name in two folders, `jobs` pairs at a time. The map paths of
/// the request are folders. A pair that is not identical gets its maps there, under its own name.
/// @param maps  receives the maps, and the removal of earlier maps of identical pairs
FolderDiff diffFolders(const std::filesystem::path& reference, const std::filesystem::path& test,
                       FolderNames names, const DiffRequest& request, int jobs, core::FileBatch& maps);

}  // namespace poinsot::compare
