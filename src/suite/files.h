// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace poinsot::suite {

struct MatchedFile {
  std::filesystem::path file;
  /// Path relative to the pattern's fixedFolder(), without the extension, such as "wave[1]" or "axes/ticks".
  std::string name;
};

bool isPattern(const std::string& path);

/// Returns the part of a pattern before the first component with a star; without a star, the file's folder.
std::filesystem::path fixedFolder(const std::filesystem::path& folder, const std::string& path);

/// Returns the files that match a pattern, sorted. The component `**` matches any number of folders. A `*` in any
/// other component matches any characters of a name. A path without a star returns itself, even if the file is
/// missing. Links to folders are not followed; hidden files and folders are skipped.
std::vector<MatchedFile> filesMatching(const std::filesystem::path& folder, const std::string& path);

/// Reports whether a file would match a pattern. The file may be missing. Links to folders in its path are
/// followed.
bool isMatch(const std::filesystem::path& folder, const std::string& pattern, const std::filesystem::path& file);

}  // namespace poinsot::suite
