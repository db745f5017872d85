// SPDX-License-Identifier: Apache-2.0
#include "suite/reference.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/folder.h"
#include "core/json.h"
#include "core/regular_file.h"

namespace poinsot::suite {

namespace fs = std::filesystem;

namespace {

std::optional<compare::PictureOrigin> originIn(const fs::path& description) try {
  return parsePictureOrigin(core::readRegularFile(description, kMostDescription, core::ErrorKind::kIo));
} catch (const core::Error&) {  // not a regular file, or too large
  return std::nullopt;
}

}  // namespace

compare::PictureOrigin describedOrigin(const fs::path& picture) {
  return originIn(descriptionOf(picture)).value_or(compare::PictureOrigin{});
}

bool isDescription(const fs::path& file) { return originIn(file).has_value(); }

std::optional<compare::PictureOrigin> parsePictureOrigin(std::string_view text) try {
  auto json = core::parseJson(text);
  if (!json.is_object()) return std::nullopt;
  json.emplace("driver", "");  // does nothing if the field exists
  constexpr std::array kFields{"renderer", "driver", "software", "scene"};
  const auto isText = [&](const char* key) { return json.contains(key) && json[key].is_string(); };
  if (json.size() != kFields.size() || !std::ranges::all_of(kFields, isText)) return std::nullopt;
  return compare::PictureOrigin{json["renderer"], json["driver"], json["software"], json["scene"]};
} catch (const core::Error&) {
  return std::nullopt;
}

bool isApprovedBeside(const fs::path& picture, const fs::path& usual) {
  const ReferenceStem stem = splitStem(picture.stem());
  return !stem.renderer.empty() && stem.name == usual.stem().native() &&
         picture.extension() == usual.extension() && slugOf(describedOrigin(picture).renderer) == stem.renderer;
}

std::vector<GoldenReference> referencesOf(const fs::path& folder, const GoldenName& name) {
  const fs::path usual = usualFile(folder, name);
  core::expectNoLinkAbove(usual, folder);
  std::vector<GoldenReference> references;
  for (const fs::path& file : core::filesIn(usual.parent_path()))
    if (file.filename() == usual.filename())
      references.insert(references.begin(), {file, describedOrigin(file)});
    else if (isApprovedBeside(file, usual) && !name.taken.contains(file.stem()))
      references.push_back({file, describedOrigin(file)});
  return references;
}

std::vector<GoldenReference> relevant(const std::vector<GoldenReference>& references,
                                      const std::string& renderer) {
  std::vector<GoldenReference> own;
  for (const GoldenReference& reference : references)
    if (reference.origin.renderer == renderer) own.push_back(reference);
  return own.empty() ? references : own;
}

}  // namespace poinsot::suite
