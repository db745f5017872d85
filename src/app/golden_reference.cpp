// SPDX-License-Identifier: Apache-2.0
#include "app/golden_reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>

#include "app/json_file.h"
#include "core/error.h"
#include "core/regular_file.h"
#include "core/text.h"

namespace poinsot::app {

namespace fs = std::filesystem;

GoldenOrigin describedOrigin(const fs::path& picture) {
  const fs::path file = descriptionOf(picture);
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return {};
  const auto origin = parseGoldenOrigin(core::readRegularFile(file, kMostDescription, core::ErrorKind::kIo));
  if (!origin)
    throw core::Error(core::ErrorKind::kIo,
                      fmt::format("{}: is no description that poinsot wrote; remove it and approve again",
                                  core::printable(file.native())));
  return *origin;
}

std::optional<GoldenOrigin> parseGoldenOrigin(std::string_view text) try {
  const auto json = parseJson(text);
  if (!json.is_object()) return std::nullopt;
  const auto textAt = [&](const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
  };
  return GoldenOrigin{textAt("renderer"), textAt("software"), textAt("scene")};
} catch (const core::Error&) {
  return std::nullopt;
}

bool isApprovedBeside(const fs::path& picture, const fs::path& usual) try {
  const ReferenceStem stem = splitStem(picture.stem());
  return !stem.renderer.empty() && stem.name == usual.stem().native() &&
         picture.extension() == usual.extension() && slugOf(describedOrigin(picture).renderer) == stem.renderer;
} catch (const core::Error&) {  // a description that cannot be read says nothing
  return false;
}

std::vector<GoldenReference> referencesOf(const fs::path& folder, const GoldenName& name) {
  const fs::path usual = usualFile(folder, name);
  expectNoLinkAbove(usual, folder);
  std::vector<GoldenReference> references;
  for (const fs::path& file : filesIn(usual.parent_path()))
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

}  // namespace poinsot::app
