// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace poinsot::suite {

/// A file that a pattern means.
struct MatchedFile {
  std::filesystem::path file;
  /// Path from the folder in which the pattern's first star is, without the extension: "wave[1]", "axes/ticks".
  std::string name;
};

/// Whether a path has a star.
bool isPattern(const std::string& path);

/// The folder before the first part of a path that has a star; of a path without one its parent.
std::filesystem::path fixedFolder(const std::filesystem::path& folder, const std::string& path);

/// Files that a path means, by name. In a part of the path `*` stands for any characters of a name; a part `**`
/// stands for any number of folders. A path without a star means itself, whether it is there or not. Links to
/// folders are not followed, hidden files and folders not looked at.
std::vector<MatchedFile> filesMatching(const std::filesystem::path& folder, const std::string& path);

/// Whether a pattern means this file, if it is made: by its name, and where links among the folders lead.
bool isMatch(const std::filesystem::path& folder, const std::string& pattern, const std::filesystem::path& file);

}  // namespace poinsot::suite
