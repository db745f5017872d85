// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/picture_rule.h"
#include "core/error.h"
#include "scene/limits.h"

namespace poinsot::suite {

/// One [[test]]: a scene, drawn at some times, or a picture that somebody else makes.
struct GoldenTest {
  std::string name;
  std::filesystem::path scene;   ///< drawn; empty if there is an image
  std::filesystem::path image;   ///< PNG or film that another program makes; empty if there is a scene
  std::string file;              ///< the one that is not empty, as the manifest has it: perhaps a pattern
  std::filesystem::path folder;  ///< `file` is a path from here
  std::string namePattern;   ///< name as the manifest has it, "*" without one; beneath it all names of the files
  bool isUnmatched = false;  ///< whether `image` is a pattern that matches no file
  std::vector<double> times_s;  ///< film times; empty: the scene's time.still
  std::optional<image::PixelSize> size;
  std::optional<int> height;           ///< in place of the size: the width keeps the scene's proportion
  core::SourceLocation at;             ///< its [[test]] in the manifest
  core::SourceLocation heightAt;       ///< where the manifest says so
  core::SourceLocation timesAt;        ///< and of the times
  std::vector<std::string> overrides;  ///< "key=value"
  std::string variant;                 ///< of an image: what made it, where references differ by that
  compare::PictureRule rule;
};

/// Returns the file that a test is of, after `before`, if the test is one of a pattern; else nothing.
std::string matchedText(const GoldenTest& test, std::string_view before);

/// A golden.toml.
struct GoldenManifest {
  std::filesystem::path file;
  std::filesystem::path references;  ///< folder of what was approved
  std::vector<GoldenTest> tests;     ///< those of a pattern by name
};

/// Reads it; paths in it are from its folder. The path of a scene or an image may be a pattern (files.h): a
/// test for each file. A manifest may be a stranger's, so scenes and images must lie below its folder, the current
/// one, that of images or an asset root, and references, which are written, below its folder or an asset root;
/// links lead no further.
/// @param images  folder from which paths of images are; empty: that of the manifest
/// @throws scene::SceneErrors with all that is wrong and where; core::Error(kIo) if it cannot be read.
GoldenManifest readGoldenManifest(const std::filesystem::path& file, const scene::Allowance& allowance = {},
                                  const std::filesystem::path& images = {});
/// The same of its text, as if it stood in that file. @throws scene::SceneErrors.
GoldenManifest parseGoldenManifest(std::string text, const std::filesystem::path& file,
                                   const scene::Allowance& allowance = {},
                                   const std::filesystem::path& images = {});

}  // namespace poinsot::suite
