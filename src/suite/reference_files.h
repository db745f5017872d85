// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>

#include "core/abi.h"

/// File names of references: NAME.png or NAME@RENDERER.png, each with a description NAME.json or
/// NAME@RENDERER.json.
namespace poinsot::suite {

inline constexpr std::size_t kMostDescription = std::size_t{64} << 10;

/// Name from which the file names of a test's references are made.
struct GoldenName {
  std::string name;       ///< name of the case; may contain folders, as in "axes/ticks"
  std::string extension;  ///< extension of the pictures, such as ".png" or ".mp4"
  /// File stems such as "ticks@x" that are names of other tests. They are not references of "ticks" for a renderer
  /// "x".
  std::set<std::string> taken = {};
};

/// File name without extension, split at its last @.
struct ReferenceStem {
  std::string name, renderer;  ///< the renderer is empty if there is no @
};

ReferenceStem splitStem(const std::string& stem);

/// Returns a renderer's name in a form for file names: each run of characters other than letters, digits and
/// points becomes one _.
std::string slugOf(const std::string& renderer);

std::filesystem::path descriptionOf(const std::filesystem::path& picture);

/// Returns the main reference of a test, NAME.png, which belongs to no particular renderer.
std::filesystem::path usualFile(const std::filesystem::path& folder, const GoldenName& name);

/// Returns a test's reference for one renderer, NAME@RENDERER.png. @param usual  usualFile() of the test
std::filesystem::path fileFor(const std::string& renderer, const std::filesystem::path& usual);

}  // namespace poinsot::suite
