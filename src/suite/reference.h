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

/// Approved picture of a test. A test usually has one reference, NAME.png. If drivers draw differently, and all of
/// them correctly, the test also has references for single renderers, NAME@RENDERER.png.
struct GoldenReference {
  std::filesystem::path picture;
  compare::PictureOrigin origin;
};

/// Parses the description of a reference, NAME.json. Returns nullopt unless the text is a JSON object with exactly
/// the fields that GoldenApproval writes. Only `driver` may be missing, as in old descriptions.
std::optional<compare::PictureOrigin> parsePictureOrigin(std::string_view text);

/// Reports whether a file is the description of a reference, see parsePictureOrigin().
bool isDescription(const std::filesystem::path& file);

/// Returns the origin from a reference's description, or an empty origin if there is no valid description.
compare::PictureOrigin describedOrigin(const std::filesystem::path& picture);

/// Reports whether a picture was approved with --beside. This is so if the picture's description names the
/// renderer that is in its file name.
/// @param usual  the test's main reference, NAME.png
bool isApprovedBeside(const std::filesystem::path& picture, const std::filesystem::path& usual);

/// Returns the references of a test, the main one first. A file NAME@X.png counts only if its description
/// NAME@X.json names the renderer X.
/// @throws core::Error(kIo) if the path contains a link to a folder
std::vector<GoldenReference> referencesOf(const std::filesystem::path& folder, const GoldenName& name);

/// Returns the references with which a picture is compared: those of its own renderer, or all if there are none.
std::vector<GoldenReference> relevant(const std::vector<GoldenReference>& references, const std::string& renderer);

}  // namespace poinsot::suite
