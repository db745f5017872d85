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
#include "image/png_file.h"
#include "output/atomic_file.h"

namespace poinsot::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostOrigin = 64 << 10, kMostPicture = std::size_t{512} << 20;

fs::path originFile(const fs::path& picture) { return fs::path(picture).replace_extension(".json"); }

/// Of a picture without one, nothing is known.
GoldenOrigin originOf(const fs::path& picture) {
  const fs::path file = originFile(picture);
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return {};
  const auto origin = parseGoldenOrigin(core::readRegularFile(file, kMostOrigin, core::ErrorKind::kIo));
  if (!origin)
    throw core::Error(core::ErrorKind::kIo, core::printable(file.native()) + ": is no JSON object of poinsot's");
  return *origin;
}

/// A renderer's name as part of a file name: what is no letter, digit or point becomes one _.
std::string slug(const std::string& renderer) {
  std::string text;
  for (const char c : renderer) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.';
    if (plain)
      text += c;
    else if (!text.empty() && text.back() != '_')
      text += '_';
  }
  while (!text.empty() && text.back() == '_') text.pop_back();
  return text.empty() ? "other" : text;
}

/// "racket" for "racket.png" and "racket@llvmpipe.png".
std::string testOf(const fs::path& picture) {
  const std::string stem = picture.stem();
  return stem.substr(0, stem.find('@'));
}

/// A link may lead anywhere, and is none.
std::vector<fs::path> picturesIn(const fs::path& folder) {
  std::vector<fs::path> pictures;
  std::error_code ignored;  // no folder has no pictures
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (image::isPngName(entry.path()) && !entry.is_symlink(ignored)) pictures.push_back(entry.path());
  std::sort(pictures.begin(), pictures.end());
  return pictures;
}

void write(const fs::path& picture, const std::string& bytes, const GoldenOrigin& origin) {
  const nlohmann::ordered_json json{
      {"renderer", origin.renderer}, {"software", origin.software}, {"scene", origin.scene}};
  output::writeFileAtomically(picture, bytes);
  output::writeFileAtomically(originFile(picture),
                              json.dump(1, ' ', true, nlohmann::json::error_handler_t::replace) + "\n");
}

void remove(const GoldenReference& reference) {
  std::error_code ignored;  // what is left is compared with again, and seen
  fs::remove(reference.picture, ignored);
  fs::remove(originFile(reference.picture), ignored);
}

/// The file that a new reference takes.
fs::path placeOf(const std::vector<GoldenReference>& there, const GoldenOrigin& origin, const fs::path& usual,
                 bool beside) {
  for (const GoldenReference& reference : there)
    if (reference.origin.renderer == origin.renderer) return reference.picture;
  if (!beside || there.empty()) return usual;
  return usual.parent_path() / fmt::format("{}@{}.png", usual.stem().native(), slug(origin.renderer));
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

std::vector<GoldenReference> referencesOf(const fs::path& folder, const std::string& name) {
  std::vector<GoldenReference> references;
  for (const fs::path& picture : picturesIn(folder))
    if (testOf(picture) == name) references.push_back({picture, originOf(picture)});
  const auto isUsual = [&](const GoldenReference& r) { return r.picture.stem() == name; };
  std::stable_partition(references.begin(), references.end(), isUsual);
  return references;
}

std::vector<GoldenReference> relevant(const std::vector<GoldenReference>& references,
                                      const std::string& renderer) {
  std::vector<GoldenReference> own;
  for (const GoldenReference& reference : references)
    if (!renderer.empty() && reference.origin.renderer == renderer) own.push_back(reference);
  return own.empty() ? references : own;
}

Approval approve(const fs::path& picture, const GoldenOrigin& origin, const fs::path& folder,
                 const std::string& name, bool beside) {
  output::makeFolders(folder);
  const auto there = referencesOf(folder, name);
  const fs::path usual = folder / (name + ".png");
  const bool isOwn =
      std::ranges::any_of(there, [&](const GoldenReference& r) { return r.origin.renderer == origin.renderer; });
  Approval approval{placeOf(there, origin, usual, beside), {}};
  write(approval.place, core::readRegularFile(picture, kMostPicture, core::ErrorKind::kIo), origin);
  if (beside) return approval;
  for (const GoldenReference& reference : there) {
    const bool holds = isOwn && reference.origin.scene == origin.scene;
    if (reference.picture == approval.place || holds) continue;
    remove(reference);
    approval.removed.push_back(reference.picture);
  }
  return approval;
}

std::vector<std::string> unusedIn(const fs::path& folder, const std::vector<std::string>& names) {
  std::vector<std::string> unused;
  for (const fs::path& picture : picturesIn(folder))
    if (std::ranges::find(names, testOf(picture)) == names.end()) unused.push_back(picture.filename());
  return unused;
}

}  // namespace poinsot::app
