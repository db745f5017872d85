// SPDX-License-Identifier: Apache-2.0
#include "app/golden_reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>

#include "app/json_file.h"
#include "app/picture_form.h"
#include "core/error.h"
#include "core/regular_file.h"
#include "core/text.h"
#include "output/atomic_file.h"

namespace poinsot::app {
namespace {

namespace fs = std::filesystem;

/// Returns what is known of a picture: nothing without a description.
GoldenOrigin originOf(const fs::path& picture) {
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

void write(const fs::path& picture, const std::string& bytes, const GoldenOrigin& origin) {
  const nlohmann::ordered_json json{
      {"renderer", origin.renderer}, {"software", origin.software}, {"scene", origin.scene}};
  output::writeFileAtomically(picture, bytes);
  output::writeFileAtomically(descriptionOf(picture),
                              json.dump(1, ' ', true, nlohmann::json::error_handler_t::replace) + "\n");
}

void remove(const GoldenReference& reference) {
  std::error_code ignored;  // what is left is compared with again, and seen
  fs::remove(reference.picture, ignored);
  fs::remove(descriptionOf(reference.picture), ignored);
}

/// Checks that a file is not the reference of another renderer, whose name makes the same file name.
void expectFree(const fs::path& place, const std::string& renderer) {
  std::error_code ignored;
  if (!fs::exists(descriptionOf(place), ignored)) return;
  const std::string other = originOf(place).renderer;
  if (other != renderer)
    throw core::Error(
        core::ErrorKind::kUsage,
        fmt::format("{}: is the reference of '{}', and that of '{}' would have the same file name; "
                    "choose another variant",
                    core::printable(place.native()), core::printable(other), core::printable(renderer)));
}

/// Returns the file that a new reference takes. @throws core::Error(kUsage) if another renderer has it.
fs::path placeOf(const std::vector<GoldenReference>& there, const GoldenOrigin& origin, const fs::path& usual,
                 bool beside) {
  for (const GoldenReference& reference : there)
    if (reference.origin.renderer == origin.renderer) return reference.picture;
  if (!beside || there.empty()) return usual;
  fs::path place = usual.parent_path() / fmt::format("{}@{}{}", usual.stem().native(), slugOf(origin.renderer),
                                                     usual.extension().native());
  expectFree(place, origin.renderer);
  return place;
}

}  // namespace

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
         picture.extension() == usual.extension() && slugOf(originOf(picture).renderer) == stem.renderer;
} catch (const core::Error&) {  // a description that cannot be read says nothing
  return false;
}

std::vector<GoldenReference> referencesOf(const fs::path& folder, const GoldenName& name) {
  const fs::path usual = usualFile(folder, name);
  expectNoLinkAbove(usual, folder);
  std::vector<GoldenReference> references;
  for (const fs::path& file : filesIn(usual.parent_path()))
    if (file.filename() == usual.filename())
      references.insert(references.begin(), {file, originOf(file)});
    else if (isApprovedBeside(file, usual))
      references.push_back({file, originOf(file)});
  return references;
}

std::vector<GoldenReference> relevant(const std::vector<GoldenReference>& references,
                                      const std::string& renderer) {
  std::vector<GoldenReference> own;
  for (const GoldenReference& reference : references)
    if (reference.origin.renderer == renderer) own.push_back(reference);
  return own.empty() ? references : own;
}

Approval approve(const fs::path& picture, const GoldenOrigin& origin, const fs::path& folder,
                 const GoldenName& name, bool beside) {
  const fs::path usual = usualFile(folder, name);
  expectNoLinkAbove(usual, folder);
  output::makeFolders(usual.parent_path());
  const auto there = referencesOf(folder, name);
  const bool isOwn =
      std::ranges::any_of(there, [&](const GoldenReference& r) { return r.origin.renderer == origin.renderer; });
  Approval approval{placeOf(there, origin, usual, beside), {}};
  write(approval.place, core::readRegularFile(picture, kMostPicture, core::ErrorKind::kIo), origin);
  if (beside) return approval;
  for (const GoldenReference& reference : there) {
    const bool holds = isOwn && !origin.scene.empty() && reference.origin.scene == origin.scene;
    if (reference.picture == approval.place || holds) continue;
    remove(reference);
    approval.removed.push_back(reference.picture);
  }
  return approval;
}

}  // namespace poinsot::app
