// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>

#include "core/abi.h"

/// Names and places of the files of references: NAME.png, NAME@RENDERER.png, and a description NAME.json of each.
namespace poinsot::suite {

/// Largest description that is read, in bytes.
inline constexpr std::size_t kMostDescription = std::size_t{64} << 10;

/// Name of a test's references, beneath the folder of references.
struct GoldenName {
  std::string name;       ///< of the case; may have folders: "axes/ticks"
  std::string extension;  ///< of its pictures: ".png", ".mp4"
  /// Stems "ticks@x" that are those of other tests, and not of this one's reference for a renderer x.
  std::set<std::string> taken = {};
};

/// A stem in two, at its last @.
struct ReferenceStem {
  std::string name, renderer;  ///< the second empty without an @
};

/// Splits "ticks@softpipe" into "ticks" and "softpipe".
ReferenceStem splitStem(const std::string& stem);

/// Returns a renderer's name as part of a file name: a run of characters other than letters, digits and points
/// becomes one _.
std::string slugOf(const std::string& renderer);

/// Returns the file that describes a picture.
std::filesystem::path descriptionOf(const std::filesystem::path& picture);

/// Returns the usual file of a test, which is not for one renderer only.
std::filesystem::path usualFile(const std::filesystem::path& folder, const GoldenName& name);

/// Returns the file of a test's reference for one renderer only. @param usual  usualFile()
std::filesystem::path fileFor(const std::string& renderer, const std::filesystem::path& usual);

}  // namespace poinsot::suite
