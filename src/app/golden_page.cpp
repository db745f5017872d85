// SPDX-License-Identifier: Apache-2.0
#include "app/golden_page.h"

#include <algorithm>

#include "app/diff_page.h"
#include "app/run_facts.h"
#include "core/shell_word.h"

namespace poinsot::app {
namespace {

DiffPageEntry entryOf(const GoldenOutcome& outcome) {
  DiffPageEntry entry{outcome.name, std::string(toString(outcome.status)), outcome.message, outcome.diff};
  entry.hasFigures = !outcome.reference.empty() && outcome.diff.hasFigures &&
                     outcome.status != GoldenStatus::kUnused && outcome.status != GoldenStatus::kError;
  entry.facts = {{"approved", outcome.reference.native()},
                 {"new", outcome.actual.native()},
                 {"renderer", outcome.origin.renderer}};
  entry.reference.file = outcome.reference;
  if (outcome.status != GoldenStatus::kIdentical) entry.actual.file = outcome.actual;
  entry.map.file = outcome.map;
  if (const auto s = outcome.status;
      s == GoldenStatus::kNear || s == GoldenStatus::kDifferent || s == GoldenStatus::kNew)
    entry.approve = core::shellWord(outcome.name);
  return entry;
}

void embedPictures(std::vector<DiffPageEntry>& entries) {
  EmbedBudget budget;
  for (DiffPageEntry* entry : worstFirst(entries)) {
    if (budget.isSpent()) return;
    embedFiles(*entry);
    budget.admit(*entry);
  }
}

std::string nameOf(const std::filesystem::path& manifest) {
  return std::filesystem::absolute(manifest).parent_path().filename();
}

}  // namespace

std::string goldenPage(const std::vector<GoldenOutcome>& outcomes, const GoldenPageRequest& request) {
  const bool passed =
      std::ranges::all_of(outcomes, [&](const GoldenOutcome& o) { return o.passes(request.exact); });
  DiffPage page{nameOf(request.manifest), passed ? "passed" : "failed", "approved", "new", "Test"};
  page.file = request.page;
  page.run = runFacts(request.manifest);
  page.approve = request.approve;
  for (const GoldenOutcome& outcome : outcomes) page.entries.push_back(entryOf(outcome));
  embedPictures(page.entries);
  return htmlOf(page);
}

}  // namespace poinsot::app
