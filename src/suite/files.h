// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace poinsot::suite {

struct MatchedFile {
  std::filesystem::path file;
  /// Path relative to the pattern's fixedFolder(), without the extension: "wave[1]", "axes/ticks".
  std::string name;
};

bool isPattern(const std::string& path);

/// Returns the folder before the first path component that has a star; the parent folder if there is no star.
std::filesystem::path fixedFolder(const std::filesystem::path& folder, const std::string& path);

/// Returns the files that a path with stars matches, sorted. In a path component, `*` matches any characters of a
/// name; a component `**` matches any number of folders. A path without a star yields itself, even if the file is
/// missing. Links to folders are not followed; hidden files and folders are skipped.
std::vector<MatchedFile> filesMatching(const std::filesystem::path& folder, const std::string& path);

/// Reports whether a file, which may be missing, would match a pattern. Links among its folders are followed.
bool isMatch(const std::filesystem::path& folder, const std::string& pattern, const std::filesystem::path& file);

}  // namespace poinsot::suite
