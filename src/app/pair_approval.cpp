// SPDX-License-Identifier: Apache-2.0
#include "app/pair_approval.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/regular_file.h"
#include "core/text.h"
#include "core/wildcard.h"
#include "output/atomic_file.h"

namespace poinsot::app {
namespace {

namespace fs = std::filesystem;

bool isMeant(const Outcome& outcome, const std::string& pattern) {
  return core::matchesWildcard(pattern, outcome.name);
}

void expectMeaning(const std::vector<Outcome>& outcomes, const std::vector<std::string>& patterns) {
  for (const std::string& pattern : patterns) {
    if (std::ranges::any_of(outcomes, [&](const Outcome& o) { return isMeant(o, pattern); })) continue;
    std::vector<std::string> names;
    for (const Outcome& outcome : outcomes) names.push_back(outcome.name);
    const auto near = core::closest(pattern, names);
    throw core::Error(core::ErrorKind::kUsage,
                      fmt::format("--update {}: no picture has this name{}", core::printable(pattern),
                                  near ? fmt::format("; did you mean '{}'?", core::printable(*near)) : ""));
  }
}

void copyPicture(const fs::path& from, const fs::path& to) {
  constexpr std::size_t kMost = std::size_t{512} << 20;
  output::makeFolders(output::folderOf(to));
  output::writeFileAtomically(to, core::readRegularFile(from, kMost, core::ErrorKind::kIo));
}

}  // namespace

PairApproval approvePairs(const std::vector<Outcome>& outcomes, const std::vector<std::string>& patterns,
                          const fs::path& reference) {
  expectMeaning(outcomes, patterns);
  PairApproval approval;
  for (const Outcome& outcome : outcomes) {
    const bool meant =
        std::ranges::any_of(patterns, [&](const std::string& pattern) { return isMeant(outcome, pattern); });
    if (!meant || outcome.status == OutcomeStatus::kIdentical) continue;
    if (outcome.status == OutcomeStatus::kError || outcome.status == OutcomeStatus::kMissing) {
      approval.complete = false;
      approval.text +=
          fmt::format("{:<10} {}: {}\n", toString(outcome.status), core::printable(outcome.name), outcome.message);
      continue;
    }
    const fs::path place = outcome.reference.empty() ? reference / outcome.name : outcome.reference;
    copyPicture(outcome.actual, place);
    approval.text += fmt::format("{}: {}\n", core::printable(place.native()), approvalText(outcome));
  }
  if (approval.text.empty()) approval.text = "nothing to approve: all of these are identical\n";
  return approval;
}

}  // namespace poinsot::app
