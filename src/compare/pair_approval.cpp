// SPDX-License-Identifier: Apache-2.0
#include "compare/pair_approval.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/file_batch.h"
#include "core/folder.h"
#include "core/regular_file.h"
#include "core/text.h"
#include "core/wildcard.h"
#include "output/target_check.h"
#include "request/picture_options.h"

namespace poinsot::compare {
namespace {

namespace fs = std::filesystem;

bool isMeant(const Outcome& outcome, const std::string& word) {
  const std::string pattern = word.starts_with("./") ? word.substr(2) : word;  // ./-x stands for the name -x
  return core::matchesWildcard(pattern, outcome.name);
}

bool isMeant(const Outcome& outcome, const std::vector<std::string>& patterns) {
  return std::ranges::any_of(patterns, [&](const std::string& pattern) { return isMeant(outcome, pattern); });
}

void expectMeaning(const std::vector<Outcome>& outcomes, const std::vector<std::string>& patterns) {
  for (const std::string& pattern : patterns) {
    if (std::ranges::any_of(outcomes, [&](const Outcome& o) { return isMeant(o, pattern); })) continue;
    std::vector<std::string> names;
    for (const Outcome& outcome : outcomes) names.push_back(outcome.name);
    const auto near = core::closest(pattern, names);
    throw core::usageError(fmt::format("--update {}: no picture has this name{}", core::printable(pattern),
                                       near ? fmt::format("; did you mean '{}'?", core::printable(*near)) : ""));
  }
}

core::AtomicFile copyOf(const fs::path& from, const fs::path& to) {
  core::makeFolders(core::folderOf(to));
  output::checkTarget(to, true);
  core::AtomicFile file(to);
  file.write(core::readRegularFile(from, request::kMostPicture, core::ErrorKind::kIo));
  return file;
}

/// Returns the reference file that an approved picture replaces.
/// @param reference  the reference picture, or the folder of reference pictures
fs::path placeOf(const Outcome& outcome, const fs::path& reference) {
  return outcome.reference.empty() ? reference / outcome.name : outcome.reference;
}

}  // namespace

void expectReplaceable(const fs::path& reference) {
  std::error_code ignored;
  if (fs::is_directory(reference, ignored))
    core::expectWritableFolder(reference);
  else
    output::checkTarget(reference, true);
}

std::vector<ApprovalFile> approvalOf(const Outcome& outcome, const fs::path& reference) {
  return {{placeOf(outcome, reference), outcome.actual}};
}

PairApproval addApprovals(core::FileBatch& batch, const std::vector<Outcome>& outcomes,
                          const std::vector<std::string>& patterns, const fs::path& reference, bool exact) {
  expectMeaning(outcomes, patterns);
  std::vector<const Outcome*> meant;
  for (const Outcome& outcome : outcomes)
    if (isMeant(outcome, patterns) && (isToApprove(outcome, exact) || !canBeApproved(outcome)))
      meant.push_back(&outcome);
  for (const Outcome* outcome : meant) core::expectNoLinkAbove(placeOf(*outcome, reference), reference);
  PairApproval approval;
  for (const Outcome* outcome : meant) {
    if (!canBeApproved(*outcome)) {
      approval.complete = false;
      approval.text += fmt::format("{:<10} {}: {}\n", toString(outcome->status), core::printable(outcome->name),
                                   outcome->message);
      continue;
    }
    const fs::path place = placeOf(*outcome, reference);
    batch.add(copyOf(outcome->actual, place));
    approval.text += fmt::format("{}: {}\n", core::printable(place.native()), approvalText(*outcome));
  }
  if (approval.text.empty()) approval.text = "nothing to approve: all of these are identical\n";
  return approval;
}

}  // namespace poinsot::compare
