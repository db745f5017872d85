// SPDX-License-Identifier: Apache-2.0
#include "app/golden_strays.h"

#include <fmt/format.h>

#include "app/golden_files.h"
#include "core/text.h"
#include "output/film_reader.h"

namespace poinsot::app {

Outcome unmatchedOutcome(const GoldenCase& pattern) {
  Outcome outcome;
  outcome.name = pattern.name;
  outcome.status = OutcomeStatus::kError;
  outcome.rule = pattern.test.rule;
  outcome.message =
      fmt::format("no PNG and no film is there of the name {}: run the program that makes them first",
                  core::printable(pattern.test.image.native()));
  return outcome;
}

namespace {

/// Folders in which references of a pattern lie, whether it matches a file now or not.
StrayPlaces placesOf(const GoldenManifest& manifest, bool all) {
  StrayPlaces places{all, {}, {}};
  for (const GoldenTest& test : manifest.tests) {
    if (!all || !isPattern(test.file)) continue;
    const std::filesystem::path folder =
        manifest.references / std::filesystem::path(test.namePattern).parent_path();
    (test.file.find("**") == std::string::npos ? places.folders : places.trees).push_back(folder);
  }
  return places;
}

}  // namespace

std::vector<Outcome> strayOutcomes(const GoldenManifest& manifest, const std::vector<GoldenCase>& cases, bool all,
                                   bool allMade) {
  std::vector<GoldenName> names;
  for (const GoldenCase& one : cases)
    if (!one.test.isUnmatched) names.push_back(one.reference());
  std::vector<Outcome> outcomes;
  for (const StrayFile& stray : strayFiles(manifest.references, names, placesOf(manifest, all))) {
    Outcome& outcome = outcomes.emplace_back();
    outcome.name = stray.file.lexically_relative(manifest.references).replace_extension();
    outcome.status = OutcomeStatus::kUnused;
    outcome.message = allMade ? stray.why : "approved, and no test makes it: first mend what is in error";
    if (output::isPictureOrFilmName(stray.file)) outcome.reference = stray.file;
  }
  return outcomes;
}

std::vector<Outcome> unusedReferences(const GoldenManifest& manifest) {
  const std::vector<GoldenCase> cases = casesOf(manifest, {});
  std::vector<Outcome> outcomes;
  for (const GoldenCase& one : cases)
    if (one.test.isUnmatched) outcomes.push_back(unmatchedOutcome(one));
  const bool allMade = outcomes.empty();
  for (Outcome& stray : strayOutcomes(manifest, cases, true, allMade)) outcomes.push_back(std::move(stray));
  return outcomes;
}

}  // namespace poinsot::app
