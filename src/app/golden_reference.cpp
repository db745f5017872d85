// SPDX-License-Identifier: Apache-2.0
#include "app/golden_reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>

#include "app/json_file.h"
#include "core/error.h"
#include "core/regular_file.h"
#include "core/text.h"
#include "output/atomic_file.h"
#include "output/film_reader.h"

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

/// Files in a folder, sorted. A link may lead anywhere, and is none.
std::vector<fs::path> filesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code ignored;  // no folder has no files
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.is_regular_file(ignored) && !entry.is_symlink(ignored)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// A stem in two, at its last @.
struct Stem {
  std::string name, renderer;  ///< the second empty without an @
};

Stem split(const std::string& stem) {
  const auto at = stem.rfind('@');
  return at == std::string::npos ? Stem{stem, ""} : Stem{stem.substr(0, at), stem.substr(at + 1)};
}

/// The usual file of a test.
fs::path usualFile(const fs::path& folder, const GoldenName& name) {
  return folder / (name.name + name.extension);
}

/// Whether a picture was approved beside the usual one of a test: its description says for which renderer.
bool isApprovedBeside(const fs::path& picture, const fs::path& usual) try {
  const Stem stem = split(picture.stem());
  return !stem.renderer.empty() && stem.name == usual.stem().native() &&
         picture.extension() == usual.extension() && slug(originOf(picture).renderer) == stem.renderer;
} catch (const core::Error&) {  // a description that cannot be read says nothing
  return false;
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
  return usual.parent_path() /
         fmt::format("{}@{}{}", usual.stem().native(), slug(origin.renderer), usual.extension().native());
}

/// Whether a JSON file is a description that approve() wrote.
bool isDescription(const fs::path& file) try {
  const auto json = parseJson(core::readRegularFile(file, kMostOrigin, core::ErrorKind::kIo));
  return json.is_object() && json.size() == 3 && json.contains("renderer") && json.contains("software") &&
         json.contains("scene");
} catch (const core::Error&) {
  return false;
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

std::vector<GoldenReference> referencesOf(const fs::path& folder, const GoldenName& name) {
  const fs::path usual = usualFile(folder, name);
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

namespace {

/// Finds the files of one folder that no test refers to.
class StrayFinder {
 public:
  StrayFinder(std::vector<fs::path> usual, bool all) : usual_(std::move(usual)), all_(all) {}

  void search(const fs::path& folder) {
    const std::vector<fs::path> files = filesIn(folder);
    std::set<std::string> stems;
    for (const fs::path& file : files)
      if (output::isPictureOrFilmName(file)) stems.insert(file.stem());
    for (const fs::path& file : files)
      if (output::isPictureOrFilmName(file))
        examine(file);
      else if (all_ && file.extension() == ".json" && !stems.contains(file.stem()) && isDescription(file))
        strays_.push_back(
            {file, "describes a picture that is not there: remove " + core::printable(file.native())});
  }

  std::vector<StrayFile> strays() { return std::move(strays_); }

 private:
  void examine(const fs::path& file) {
    if (std::ranges::find(usual_, file) != usual_.end()) return;
    const Stem stem = split(file.stem());
    const fs::path besides = file.parent_path() / (stem.name + file.extension().native());
    const bool ofATest = !stem.renderer.empty() && std::ranges::find(usual_, besides) != usual_.end();
    if (ofATest && isApprovedBeside(file, besides)) return;
    if (ofATest)
      strays_.push_back(
          {file, fmt::format("lies beside {} but was not approved: approve it by --update --beside, or "
                             "remove {}",
                             core::printable(besides.filename().native()), core::printable(file.native()))});
    else if (all_)
      strays_.push_back({file, "approved, and no test makes it: remove " + withDescription(file)});
  }

  /// A picture, and its description if there is one.
  static std::string withDescription(const fs::path& file) {
    std::error_code ignored;
    const fs::path json = originFile(file);
    const std::string picture = core::printable(file.native());
    return fs::exists(json, ignored) ? fmt::format("{} and {}", picture, core::printable(json.native())) : picture;
  }

  std::vector<fs::path> usual_;
  bool all_;
  std::vector<StrayFile> strays_;
};

}  // namespace

namespace {

/// A folder and all below it; links are not followed.
void addTree(const fs::path& root, std::set<fs::path>& folders) {
  folders.insert(root);
  std::error_code ignored;  // no folder has no files
  for (const auto& entry : fs::directory_iterator(root, ignored))
    if (entry.is_directory(ignored) && !entry.is_symlink(ignored)) addTree(entry.path(), folders);
}

/// The path of a folder without a slash at its end.
fs::path plain(const fs::path& folder) { return (folder / ".").parent_path(); }

}  // namespace

std::vector<StrayFile> strayFiles(const fs::path& folder, const std::vector<GoldenName>& names,
                                  const StrayPlaces& places) {
  std::vector<fs::path> usual;
  std::set<fs::path> folders;
  if (places.all) folders.insert(plain(folder));
  for (const fs::path& other : places.folders) folders.insert(plain(other));
  for (const fs::path& tree : places.trees) addTree(plain(tree), folders);
  for (const GoldenName& name : names) {
    usual.push_back(usualFile(folder, name));
    folders.insert(usual.back().parent_path());
  }
  StrayFinder finder(std::move(usual), places.all);
  for (const fs::path& each : folders) finder.search(each);
  return finder.strays();
}

}  // namespace poinsot::app
