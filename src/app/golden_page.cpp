// SPDX-License-Identifier: Apache-2.0
#include "app/golden_page.h"

#include <algorithm>

#include "app/diff_page.h"

namespace poinsot::app {
namespace {

DiffPageEntry::Png pngOf(const std::filesystem::path& file) { return file.empty() ? "" : pngFile(file); }

DiffPageEntry entryOf(const GoldenOutcome& outcome) {
  DiffPageEntry entry{outcome.name, std::string(toString(outcome.status)), outcome.message, outcome.diff};
  entry.hasFigures = !outcome.reference.empty() && outcome.diff.hasFigures &&
                     outcome.status != GoldenStatus::kUnused && outcome.status != GoldenStatus::kError;
  entry.facts = {{"approved", outcome.reference.native()},
                 {"new", outcome.actual.native()},
                 {"renderer", outcome.origin.renderer}};
  return entry;
}

void addPictures(DiffPageEntry& entry, const GoldenOutcome& outcome) {
  entry.reference = pngOf(outcome.reference);
  if (outcome.status == GoldenStatus::kIdentical) return;
  entry.actual = pngOf(outcome.actual);
  entry.difference = pngOf(outcome.difference);
  entry.map = pngOf(outcome.map);
}

}  // namespace

std::string goldenPage(const std::string& suite, const std::vector<GoldenOutcome>& outcomes, bool exact) {
  const bool passed = std::ranges::all_of(outcomes, [&](const GoldenOutcome& o) { return o.passes(exact); });
  DiffPage page{suite, passed ? "passed" : "failed", "approved", "new", "Test"};
  for (const GoldenOutcome& outcome : outcomes) {
    const bool room = page.hasRoom();
    DiffPageEntry& entry = page.entries.emplace_back(entryOf(outcome));
    if (room)
      addPictures(entry, outcome);
    else
      entry.facts.emplace_back("pictures", "left out, as the page would become too large");
  }
  return htmlOf(page);
}

}  // namespace poinsot::app
