// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace poinsot::app {

/// What a picture was made with: kept beside a reference, in NAME.json.
struct GoldenOrigin {
  std::string renderer;  ///< GL_RENDERER; empty for pictures of others
  std::string software;  ///< "poinsot 0.1.0"
  std::string scene;     ///< SHA-256 of the scene and what it names, in hexadecimal; empty for pictures of others
};

/// A picture that was approved for a test. Usually there is one, NAME.png; where drivers draw differently and each
/// is right, others stand beside it, NAME@RENDERER.png.
struct GoldenReference {
  std::filesystem::path picture;
  GoldenOrigin origin;
};

/// Those of a test: the usual one first. @throws core::Error(kIo) for a NAME.json that is none of ours.
std::vector<GoldenReference> referencesOf(const std::filesystem::path& folder, const std::string& name);

/// Which of them a picture is compared with: those of its own renderer, if there are any, else all.
std::vector<GoldenReference> relevant(const std::vector<GoldenReference>& references, const std::string& renderer);

/// Makes `picture` the reference: in place of the one of its renderer, or, with `beside`, besides those of others;
/// else in place of all. @returns the file. @throws core::Error(kIo).
std::filesystem::path approve(const std::filesystem::path& picture, const GoldenOrigin& origin,
                              const std::filesystem::path& folder, const std::string& name, bool beside);

/// Names of the pictures in the folder that belong to no test of these names.
std::vector<std::string> unusedIn(const std::filesystem::path& folder, const std::vector<std::string>& names);

}  // namespace poinsot::app
