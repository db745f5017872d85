// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/picture_origin.h"
#include "suite/reference_files.h"

namespace poinsot::suite {

/// A picture that was approved for a test. Usually there is one, NAME.png; where drivers draw differently and each
/// is right, others stand beside it, NAME@RENDERER.png.
struct GoldenReference {
  std::filesystem::path picture;
  compare::PictureOrigin origin;
};

/// Reads a NAME.json. Returns nothing unless it is an object of exactly these texts, as GoldenApproval writes.
/// Only the driver may be missing, because early references lack it.
std::optional<compare::PictureOrigin> parsePictureOrigin(std::string_view text);

/// Whether a file is such a NAME.json.
bool isDescription(const std::filesystem::path& file);

/// Returns the origin that the NAME.json of a picture describes; an empty one if it describes none.
compare::PictureOrigin describedOrigin(const std::filesystem::path& picture);

/// Whether a picture was approved beside the usual one of a test: its description says for which renderer.
bool isApprovedBeside(const std::filesystem::path& picture, const std::filesystem::path& usual);

/// References of a test, the usual one first. A NAME@X counts only if its NAME@X.json says that it was approved
/// for the renderer X. @throws core::Error(kIo) for a link to a folder.
std::vector<GoldenReference> referencesOf(const std::filesystem::path& folder, const GoldenName& name);

/// Which of them a picture is compared with: those of its own renderer, if there are any, else all.
std::vector<GoldenReference> relevant(const std::vector<GoldenReference>& references, const std::string& renderer);

}  // namespace poinsot::suite
