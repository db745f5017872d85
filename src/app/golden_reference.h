// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/golden_reference_files.h"

namespace poinsot::app {

/// What a picture was made with: kept beside a reference, in NAME.json.
struct GoldenOrigin {
  std::string renderer;  ///< GL_RENDERER; the variant of a picture that another program made; empty without one
  std::string software;  ///< "poinsot 0.1.0"
  std::string scene;     ///< SHA-256 of the scene and what it names, in hexadecimal; empty for pictures of others
};

/// A picture that was approved for a test. Usually there is one, NAME.png; where drivers draw differently and each
/// is right, others stand beside it, NAME@RENDERER.png.
struct GoldenReference {
  std::filesystem::path picture;
  GoldenOrigin origin;
};

/// What a NAME.json says: a text that is missing is empty. Nothing where it is no JSON object.
std::optional<GoldenOrigin> parseGoldenOrigin(std::string_view text);

/// Whether a picture was approved beside the usual one of a test: its description says for which renderer.
bool isApprovedBeside(const std::filesystem::path& picture, const std::filesystem::path& usual);

/// References of a test, the usual one first. A NAME@X counts only if its NAME@X.json says that it was approved
/// for the renderer X. @throws core::Error(kIo) for a NAME.json that is none of ours, and for a link to a folder.
std::vector<GoldenReference> referencesOf(const std::filesystem::path& folder, const GoldenName& name);

/// Which of them a picture is compared with: those of its own renderer, if there are any, else all.
std::vector<GoldenReference> relevant(const std::vector<GoldenReference>& references, const std::string& renderer);

/// What approving did.
struct Approval {
  std::filesystem::path place;
  std::vector<std::filesystem::path> removed;
};

/// Makes `picture` the reference of its renderer. Those of other renderers stay with `beside`, and, where its own
/// was there already, if they are of the same scene; else they are removed: nobody looked at what they should be
/// now.
/// @throws core::Error(kIo); (kUsage) if the file of a renderer is that of another.
Approval approve(const std::filesystem::path& picture, const GoldenOrigin& origin,
                 const std::filesystem::path& folder, const GoldenName& name, bool beside);

}  // namespace poinsot::app
