// SPDX-License-Identifier: Apache-2.0
#include "suite/strays.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>

#include "core/error.h"
#include "core/folder.h"
#include "core/text.h"
#include "core/wildcard.h"
#include "output/film_reader.h"
#include "suite/files.h"
#include "suite/values.h"

namespace poinsot::suite {
namespace {

namespace fs = std::filesystem;

struct StrayFile {
  fs::path file;
  std::string why;         ///< why the file is a stray, and what to do
  bool isMissing = false;  ///< whether only the file's image is missing
};

class StrayFinder {
 public:
  StrayFinder(const fs::path& root, std::vector<fs::path> usual, std::vector<const GoldenTest*> patterns, bool all)
      : root_(root), usual_(std::move(usual)), patterns_(std::move(patterns)), all_(all) {}

  void search(const fs::path& folder) {
    const std::vector<fs::path> files = core::filesIn(folder), links = core::filesIn(folder, true);
    std::set<std::string> stems;
    for (const fs::path& file : files)
      if (output::isPictureOrFilmName(file)) stems.insert(file.stem());
    for (const fs::path& file : files)
      if (output::isPictureOrFilmName(file))
        examine(file);
      else if (all_ && file.extension() == ".json" && !stems.contains(file.stem()) && isDescription(file))
        strays_.push_back({file, whyAlone(file, links)});
  }

  std::vector<StrayFile> strays() { return std::move(strays_); }

 private:
  static std::string whyAlone(const fs::path& description, const std::vector<fs::path>& links) {
    for (const fs::path& link : links)
      if (link.stem() == description.stem() && output::isPictureOrFilmName(link))
        return fmt::format("{} is a link, which cannot be a reference; replace it with the picture itself",
                           core::printable(link.native()));
    return "describes a picture that does not exist; remove " + core::printable(description.native());
  }

  void examine(const fs::path& file) {
    if (std::ranges::find(usual_, file) != usual_.end()) return;
    const ReferenceStem stem = splitStem(file.stem());
    const fs::path besides = file.parent_path() / (stem.name + file.extension().native());
    const bool ofATest = !stem.renderer.empty() && std::ranges::find(usual_, besides) != usual_.end();
    if (ofATest && isApprovedBeside(file, besides)) return;
    if (ofATest)
      strays_.push_back(
          {file, fmt::format("lies beside {} but was not approved; approve it with --update --beside, or "
                             "remove {}",
                             core::printable(besides.filename().native()), withDescription(file))});
    else if (const GoldenTest* const pattern = patternOf(file))
      strays_.push_back(
          {file,
           fmt::format("approved, but {} has no such image; run the program that makes it, or, if the image is "
                       "gone for good, remove {}",
                       core::printable(pattern->file), withDescription(file)),
           true});
    else if (all_)
      strays_.push_back({file, "approved, but no test makes it; remove " + withDescription(file)});
  }

  /// Returns the pattern of images to which a reference could belong; null if there is none.
  const GoldenTest* patternOf(const fs::path& file) const {
    const fs::path relative = file.lexically_relative(root_);
    const std::string name = (relative.parent_path() / relative.stem()).native();
    for (const GoldenTest* test : patterns_) {
      const std::string extension = fs::path(test->file).extension();
      const bool inFolder = test->file.find("**") != std::string::npos ||
                            relative.parent_path() == fs::path(test->namePattern).parent_path();
      if (inFolder && core::matchesWildcard(test->namePattern, name) &&
          (extension.empty() || isPattern(extension) || extension == file.extension()))
        return test;
    }
    return nullptr;
  }

  /// Returns the names of a picture and of its description. Leaves out the description if it is missing, or if it
  /// also belongs to a test.
  std::string withDescription(const fs::path& file) const {
    std::error_code ignored;
    const fs::path json = descriptionOf(file);
    const std::string picture = core::printable(file.native());
    const bool isShared = std::ranges::find(usual_, json, descriptionOf) != usual_.end();
    return !isShared && fs::exists(json, ignored)
               ? fmt::format("{} and {}", picture, core::printable(json.native()))
               : picture;
  }

  fs::path root_;
  std::vector<fs::path> usual_;
  std::vector<const GoldenTest*> patterns_;
  bool all_;
  std::vector<StrayFile> strays_;
};

void addTree(const fs::path& root, std::set<fs::path>& folders) {
  folders.insert(root);
  std::error_code ignored;  // a missing folder counts as an empty one
  for (const auto& entry : fs::directory_iterator(root, ignored))
    if (entry.is_directory(ignored) && !entry.is_symlink(ignored)) addTree(entry.path(), folders);
}

/// Removes a trailing slash.
fs::path plain(const fs::path& folder) { return (folder / ".").parent_path(); }

/// Adds the folders that can contain a pattern's references, even if the pattern matches no file at present.
void addPlaces(const GoldenManifest& manifest, const GoldenTest& pattern, std::set<fs::path>& folders) {
  const fs::path folder = plain(manifest.references / fs::path(pattern.namePattern).parent_path());
  if (!isBeneath(folder, manifest.references)) return;
  if (pattern.file.find("**") == std::string::npos)
    folders.insert(folder);
  else
    addTree(folder, folders);
}

/// Returns the patterns of images whose text is in `only`, or all if `only` is empty.
std::vector<const GoldenTest*> imagePatterns(const GoldenManifest& manifest,
                                             const std::vector<std::string>& only) {
  std::vector<const GoldenTest*> patterns;
  for (const GoldenTest& test : manifest.tests) {
    const bool wanted = only.empty() || std::ranges::find(only, test.file) != only.end();
    const bool isNew = std::ranges::find(patterns, test.file, &GoldenTest::file) == patterns.end();
    if (test.scene.empty() && isPattern(test.file) && wanted && isNew) patterns.push_back(&test);
  }
  return patterns;
}

/// Returns the pictures and descriptions that belong to no test, and the references whose image is missing.
/// @param only  requested tests; if empty, every file is examined
std::vector<StrayFile> strayFiles(const GoldenManifest& manifest, const std::vector<GoldenName>& names,
                                  const std::vector<std::string>& only) {
  std::vector<fs::path> usual;
  std::set<fs::path> folders;
  if (only.empty()) folders.insert(plain(manifest.references));
  const std::vector<const GoldenTest*> patterns = imagePatterns(manifest, only);
  for (const GoldenTest* const pattern : patterns) addPlaces(manifest, *pattern, folders);
  for (const GoldenTest& test : manifest.tests)
    if (only.empty() && isPattern(test.file)) addPlaces(manifest, test, folders);
  for (const GoldenName& name : names) {
    usual.push_back(usualFile(manifest.references, name));
    folders.insert(usual.back().parent_path());
  }
  StrayFinder finder(plain(manifest.references), std::move(usual), patterns, only.empty());
  for (const fs::path& folder : folders)
    if (isBeneath(folder, manifest.references)) finder.search(folder);
  return finder.strays();
}

}  // namespace

compare::Outcome unmatchedOutcome(const GoldenCase& pattern) {
  compare::Outcome outcome;
  outcome.name = pattern.name;
  outcome.status = compare::OutcomeStatus::kError;
  outcome.rule = pattern.test.rule;
  outcome.message = fmt::format("{} matches no PNG and no film; run the program that makes them first",
                                core::printable(pattern.test.image.native()));
  return outcome;
}

std::vector<compare::Outcome> strayOutcomes(const GoldenManifest& manifest, const std::vector<GoldenCase>& cases,
                                            const std::vector<std::string>& only, bool allMade) {
  std::vector<GoldenName> names;
  for (const GoldenCase& one : cases)
    if (!one.test.isUnmatched) names.push_back(one.reference());
  std::vector<compare::Outcome> outcomes;
  for (const StrayFile& stray : strayFiles(manifest, names, only)) {
    compare::Outcome& outcome = outcomes.emplace_back();
    outcome.name = stray.file.lexically_relative(manifest.references).replace_extension();
    outcome.status = stray.isMissing ? compare::OutcomeStatus::kMissing : compare::OutcomeStatus::kUnused;
    outcome.message =
        allMade || stray.isMissing ? stray.why : "approved, but no test makes it; first fix the tests with errors";
    if (output::isPictureOrFilmName(stray.file)) outcome.reference = stray.file;
  }
  return outcomes;
}

std::vector<compare::Outcome> unusedReferences(const GoldenManifest& manifest) {
  const std::vector<GoldenCase> cases = casesOf(manifest, {});
  std::vector<compare::Outcome> outcomes;
  for (const GoldenCase& one : cases)
    if (one.test.isUnmatched) outcomes.push_back(unmatchedOutcome(one));
  const bool allMade = outcomes.empty();
  for (compare::Outcome& stray : strayOutcomes(manifest, cases, {}, allMade)) outcomes.push_back(std::move(stray));
  return outcomes;
}

}  // namespace poinsot::suite
