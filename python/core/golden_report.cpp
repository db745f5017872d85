// SPDX-License-Identifier: Apache-2.0
#include "golden_report.h"

#include <algorithm>

#include "compare/diff_json.h"
#include "compare/file_diff.h"
#include "compare/markdown.h"
#include "compare/outcome_page.h"
#include "core/error.h"
#include "core/file_batch.h"
#include "core/parallel.h"

namespace poinsot::python {
namespace {

using compare::Outcome;
using compare::OutcomeStatus;

OutcomeStatus statusOf(const std::string& word) {
  for (const OutcomeStatus status : compare::outcomeStatuses())
    if (compare::toString(status) == word) return status;
  return word == "approved" ? OutcomeStatus::kIdentical : OutcomeStatus::kError;
}

compare::DiffRequest requestOf(const GoldenRow& row) {
  compare::DiffRequest request{ruleOf(row.rule, row.ignore)};
  request.rule.mask = row.mask;
  return request;
}

/// Compares the pictures of a row. The row's own status and message stay, because they follow from the test.
Outcome outcomeOf(const GoldenRow& row) {
  Outcome outcome;
  outcome.status = statusOf(row.status);
  if (!row.baseline.empty() && !row.actual.empty() && outcome.status != OutcomeStatus::kIdentical) try {
      const compare::DiffRequest request = requestOf(row);
      outcome.diff = compare::compareFiles(row.baseline, row.actual, request).diff;
      outcome.rule = request.rule;
    } catch (const core::Error& error) {
      outcome.diff = compare::unreadablePair(error);
    }
  // The test has decided, for example by pytest-mpl's tolerance.
  if (outcome.status == OutcomeStatus::kIdentical) outcome.diff.verdict = compare::Verdict::kIdentical;
  if (outcome.status == OutcomeStatus::kNear) outcome.diff.verdict = compare::Verdict::kNear;
  outcome.name = row.name;
  outcome.message = row.message;
  outcome.reference = row.baseline;
  outcome.actual = row.actual;
  if (row.status != "approved") outcome.approval = {{row.place, row.actual}};
  return outcome;
}

}  // namespace

GoldenTexts writeGoldenReport(const std::filesystem::path& page, const std::string& title,
                              const std::filesystem::path& place, const std::vector<GoldenRow>& rows, int jobs) {
  std::vector<Outcome> outcomes(rows.size());
  core::forEachIndex(rows.size(), jobs, [&](std::size_t i) { outcomes[i] = outcomeOf(rows[i]); });
  const bool failed = std::ranges::any_of(outcomes, [](const Outcome& outcome) {
    return outcome.status != OutcomeStatus::kIdentical && outcome.status != OutcomeStatus::kNear;
  });
  compare::OutcomePageHead head{title, failed ? "failed" : "passed", "", "baseline", "new", "Test"};
  head.page = page;
  head.place = place;
  core::FileBatch batch;
  batch.write(page, compare::outcomePage(outcomes, head, jobs));
  batch.commit();
  compare::OutcomeReport report;
  report.suite = title;
  report.page = page.lexically_proximate(std::filesystem::current_path());
  return {compare::suiteJson(outcomes, {}), compare::markdownOf(outcomes, report)};
}

}  // namespace poinsot::python
