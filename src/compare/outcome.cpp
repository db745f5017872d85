// SPDX-License-Identifier: Apache-2.0
#include "compare/outcome.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/shell_word.h"
#include "core/text.h"
#include "core/wildcard.h"

namespace poinsot::compare {
namespace {

namespace fs = std::filesystem;

constexpr OutcomeStatus kAll[] = {OutcomeStatus::kIdentical, OutcomeStatus::kNear, OutcomeStatus::kDifferent,
                                  OutcomeStatus::kMissing,   OutcomeStatus::kNew,  OutcomeStatus::kUnused,
                                  OutcomeStatus::kError};

fs::path writtenMap(const std::optional<fs::path>& place, const std::string& name, const PictureDiff& diff) {
  const bool written = place && diff.hasFigures && diff.verdict != Verdict::kIdentical;
  return written ? *place / name : fs::path();
}

Outcome loneOutcome(const std::string& name, OutcomeStatus status) {
  Outcome outcome;
  outcome.name = name;
  outcome.status = status;
  return outcome;
}

bool isStoredOtherwise(const Outcome& outcome) {
  return outcome.status == OutcomeStatus::kIdentical && !outcome.diff.storedAlike;
}

std::string storageText(const PictureDiff& diff) {
  return diff.notes.empty() ? "the same pixels are stored in another format" : core::joined(diff.notes, "; ");
}

}  // namespace

std::string_view toString(OutcomeStatus status) {
  constexpr std::string_view kNames[] = {"identical", "near", "different", "new", "missing", "unused", "error"};
  return kNames[static_cast<std::size_t>(status)];
}

OutcomeStatus statusOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::kIdentical:
      return OutcomeStatus::kIdentical;
    case Verdict::kNear:
      return OutcomeStatus::kNear;
    case Verdict::kDifferent:
      break;
  }
  return OutcomeStatus::kDifferent;
}

bool canBeApproved(const Outcome& outcome) {
  return outcome.status != OutcomeStatus::kError && outcome.status != OutcomeStatus::kUnused &&
         outcome.status != OutcomeStatus::kMissing;
}

std::string reasonOf(const Outcome& outcome) {
  if (isStoredOtherwise(outcome))
    return fmt::format("{}; --exact requires the same storage", storageText(outcome.diff));
  const std::string words = wordsOf(outcome.diff.changes);
  if (words.empty()) return outcome.message.empty() ? "not identical" : outcome.message;
  return outcome.message.empty() ? words : outcome.message + "; " + words;
}

std::span<const OutcomeStatus> outcomeStatuses() { return kAll; }

std::string countsText(const std::vector<Outcome>& outcomes) {
  std::string text;
  for (const OutcomeStatus status : kAll) {
    const auto count = std::ranges::count(outcomes, status, &Outcome::status);
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, toString(status));
  }
  return text;
}

Verdict verdictOf(const std::vector<Outcome>& outcomes) {
  Verdict worst = Verdict::kIdentical;
  for (const Outcome& outcome : outcomes)
    worst = std::max(worst, outcome.passes(false) ? outcome.diff.verdict : Verdict::kDifferent);
  return worst;
}

std::ptrdiff_t countFailures(const std::vector<Outcome>& outcomes, bool exact) {
  return std::ranges::count_if(outcomes, [&](const Outcome& o) { return !o.passes(exact); });
}

Outcome outcomeOf(const PictureDiff& diff, const fs::path& reference, const fs::path& test,
                  const DiffRequest& request) {
  Outcome outcome;
  outcome.name = diff.name.empty() ? test.filename().native() : diff.name;
  outcome.status = diff.isReadable ? statusOf(diff.verdict) : OutcomeStatus::kError;
  outcome.message = reasonOf(diff);
  outcome.diff = diff;
  outcome.reference = reference;
  outcome.actual = test;
  outcome.rule = request.rule;
  outcome.map = writtenMap(request.map, diff.name, diff);
  outcome.difference = writtenMap(request.difference, diff.name, diff);
  return outcome;
}

std::vector<Outcome> outcomesOf(const FolderDiff& diff, const fs::path& reference, const fs::path& test,
                                const DiffRequest& request) {
  std::vector<Outcome> outcomes;
  for (const PictureDiff& pair : diff.pictures)
    outcomes.push_back(outcomeOf(pair, reference / pair.name, test / pair.name, request));
  for (const std::string& name : diff.names.onlyInReference) {
    outcomes.push_back(loneOutcome(name, OutcomeStatus::kMissing));
    outcomes.back().reference = reference / name;
    outcomes.back().message = fmt::format("only in the reference; if the new picture is gone for good, remove {}",
                                          core::printable(outcomes.back().reference.native()));
  }
  for (const std::string& name : diff.names.onlyInTest) {
    outcomes.push_back(loneOutcome(name, OutcomeStatus::kNew));
    outcomes.back().actual = test / name;
    outcomes.back().message = "nothing in the reference has this name";
  }
  return outcomes;
}

std::string approvalText(const Outcome& outcome) {
  if (outcome.status == OutcomeStatus::kNew) return "approved as the first reference of its test";
  if (isStoredOtherwise(outcome)) return "approved, " + storageText(outcome.diff);
  if (!outcome.diff.mismatch.empty()) return "approved, " + outcome.diff.mismatch;
  const ImageDifference& d = outcome.diff.figures;
  return fmt::format("approved, {} pixels changed, largest {:.4g}, FLIP mean {:.3g}, max {:.3g}",
                     d.differingPixels, d.maxAbs, d.flip.mean, d.flip.max);
}

std::string approvalWord(const std::string& name) {
  return core::shellWord((name.starts_with('-') ? "./" : "") + core::wildcardOf(name));
}

std::string approveCommand(const std::vector<Outcome>& outcomes, const OutcomeReport& report) {
  constexpr std::size_t kMostNames = 20;
  std::vector<std::string> names;
  for (const Outcome& outcome : outcomes)
    if (!outcome.passes(report.exact) && canBeApproved(outcome)) names.push_back(approvalWord(outcome.name));
  if (names.empty()) return "";
  if (report.approve.empty() || !report.approveBy.empty()) return report.approveBy;
  if (names.size() > kMostNames) names = {core::shellWord("*")};
  return fmt::format("{} {}", report.approve, core::joined(names, " "));
}

}  // namespace poinsot::compare
