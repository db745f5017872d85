// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>

#include "core/abi.h"

/// File names of references: NAME.png, NAME@RENDERER.png, and a description NAME.json of each.
namespace poinsot::suite {

inline constexpr std::size_t kMostDescription = std::size_t{64} << 10;

/// Identifies a test's references below the folder of references.
struct GoldenName {
  std::string name;       ///< name of the case; may contain folders: "axes/ticks"
  std::string extension;  ///< extension of the pictures: ".png", ".mp4"
  /// Stems such as "ticks@x" that belong to other tests; this test cannot use them for a renderer x.
  std::set<std::string> taken = {};
};

/// File stem, split at its last @.
struct ReferenceStem {
  std::string name, renderer;  ///< the renderer is empty if there is no @
};

ReferenceStem splitStem(const std::string& stem);

/// Returns a renderer's name as part of a file name: each run of characters other than letters, digits and points
/// becomes one _.
std::string slugOf(const std::string& renderer);

std::filesystem::path descriptionOf(const std::filesystem::path& picture);

/// Returns the main reference of a test, NAME.png, which is not specific to a renderer.
std::filesystem::path usualFile(const std::filesystem::path& folder, const GoldenName& name);

/// Returns a test's reference for one renderer, NAME@RENDERER.png. @param usual  usualFile() of the test
std::filesystem::path fileFor(const std::string& renderer, const std::filesystem::path& usual);

}  // namespace poinsot::suite
