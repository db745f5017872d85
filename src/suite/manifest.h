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

/// Test of a manifest, from a [[test]] table: a scene to draw at some times, or an image from another program.
struct GoldenTest {
  std::string name;
  std::filesystem::path scene;   ///< scene to draw; empty if there is an image
  std::filesystem::path image;   ///< PNG or film of another program; empty if there is a scene
  std::string file;              ///< `scene` or `image` as written in the manifest; may be a pattern
  std::filesystem::path folder;  ///< folder to which `file` is relative
  std::string namePattern;   ///< name as written in the manifest, "*" by default; matches a pattern's references
  bool isUnmatched = false;  ///< whether the pattern `image` matches no file
  std::vector<double> times_s;  ///< film times in seconds; if empty, the scene's time.still
  std::optional<image::PixelSize> size;
  std::optional<int> height;  ///< height in pixels; replaces size and keeps the scene's proportions
  core::SourceLocation at;    ///< position of the [[test]] in the manifest
  core::SourceLocation heightAt;
  core::SourceLocation timesAt;
  std::vector<std::string> overrides;  ///< "key=value"
  std::string variant;                 ///< driver or machine that made the image
  compare::PictureRule rule;
};

/// Returns `before` and the test's file if the test comes from a pattern; otherwise, an empty string.
std::string matchedText(const GoldenTest& test, std::string_view before);

struct GoldenManifest {
  std::filesystem::path file;
  std::filesystem::path references;
  std::vector<GoldenTest> tests;  ///< tests of the same pattern are adjacent, sorted by file
};

/// Reads a manifest. Its paths are relative to its folder. If a scene or image is a pattern (files.h), each
/// matching file becomes a test.
/// Manifests may come from strangers. Scenes and images must therefore lie below the manifest's folder, the
/// current folder, `images` or an asset root. References must lie below the manifest's folder or an asset root,
/// because they are written. A link must not lead out of these folders.
/// @param images  folder to which the paths of images are relative; if empty, the manifest's folder
/// @throws scene::SceneErrors with all errors and their places; core::Error(kIo) if the file cannot be read
GoldenManifest readGoldenManifest(const std::filesystem::path& file, const scene::Allowance& allowance = {},
                                  const std::filesystem::path& images = {});
/// Parses the text of a manifest. @param file path of the manifest, to which its paths are relative
/// @throws scene::SceneErrors
GoldenManifest parseGoldenManifest(std::string text, const std::filesystem::path& file,
                                   const scene::Allowance& allowance = {},
                                   const std::filesystem::path& images = {});

}  // namespace poinsot::suite
