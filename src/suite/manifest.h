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

/// One [[test]] of a manifest: a scene to draw at some times, or an image that another program makes.
struct GoldenTest {
  std::string name;
  std::filesystem::path scene;   ///< scene to draw; empty if there is an image
  std::filesystem::path image;   ///< PNG or film of another program; empty if there is a scene
  std::string file;              ///< scene or image as written in the manifest, perhaps a pattern
  std::filesystem::path folder;  ///< folder to which `file` is relative
  std::string namePattern;   ///< name as written in the manifest, "*" by default; references of a pattern match it
  bool isUnmatched = false;  ///< whether the pattern `image` matches no file
  std::vector<double> times_s;  ///< film times, s; if empty, the scene's time.still
  std::optional<image::PixelSize> size;
  std::optional<int> height;  ///< height in pixels, replaces size; the width follows from the scene's proportions
  core::SourceLocation at;    ///< place of the [[test]]
  core::SourceLocation heightAt;
  core::SourceLocation timesAt;
  std::vector<std::string> overrides;  ///< "key=value"
  std::string variant;                 ///< driver or machine that made the image
  compare::PictureRule rule;
};

/// Returns `before` and the test's file if the test comes from a pattern, otherwise an empty string.
std::string matchedText(const GoldenTest& test, std::string_view before);

struct GoldenManifest {
  std::filesystem::path file;
  std::filesystem::path references;
  std::vector<GoldenTest> tests;  ///< tests of one pattern are adjacent, sorted by file
};

/// Reads a manifest, whose paths are relative to its folder. A pattern (files.h) as scene or image yields one test
/// for each file. Manifests may come from strangers. Scenes and images must therefore lie below the manifest's
/// folder, the current folder, `images` or an asset root. References, which are written, must lie below the
/// manifest's folder or an asset root. Links may not lead elsewhere.
/// @param images  folder to which the paths of images are relative; if empty, the manifest's folder
/// @throws scene::SceneErrors with all errors and their places; core::Error(kIo) if the file cannot be read
GoldenManifest readGoldenManifest(const std::filesystem::path& file, const scene::Allowance& allowance = {},
                                  const std::filesystem::path& images = {});
/// Reads a manifest from its text, as if the text were in `file`. @throws scene::SceneErrors
GoldenManifest parseGoldenManifest(std::string text, const std::filesystem::path& file,
                                   const scene::Allowance& allowance = {},
                                   const std::filesystem::path& images = {});

}  // namespace poinsot::suite
