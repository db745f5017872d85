// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compare/approval_files.h"
#include "compare/folder_diff.h"
#include "compare/picture_diff.h"
#include "compare/picture_origin.h"

namespace poinsot::compare {

enum class OutcomeStatus {
  kIdentical,
  kNear,
  kDifferent,
  kNew,      ///< no reference exists
  kMissing,  ///< only the reference exists
  kUnused,   ///< no test uses the reference
  kError     ///< the picture could not be made or read
};

std::string_view toString(OutcomeStatus status);

/// Result of one test: a case of a suite, or a pair of pictures or films.
struct Outcome {
  std::string name;
  OutcomeStatus status = OutcomeStatus::kError;
  std::string message;                    ///< reason of a failure or of a near result, followed by originChange()
  PictureDiff diff;                       ///< difference from `reference`
  std::filesystem::path reference;        ///< nearest approved picture; empty if there is none
  PictureOrigin approved;                 ///< origin of the reference
  std::filesystem::path actual;           ///< new picture; empty if there is none
  std::string pixels;                     ///< pixelDigest() of a suite's new picture; may be empty
  std::filesystem::path map, difference;  ///< maps written for this outcome; empty if not written
  PictureOrigin origin;                   ///< origin of the new picture
  PictureRule rule;
  std::vector<ApprovalFile> approval;  ///< files that approve the new picture; empty if a page cannot approve it
  double seconds = 0;                  ///< duration of the comparison

  bool passes(bool exact) const {
    const bool compared = status == OutcomeStatus::kIdentical || status == OutcomeStatus::kNear;
    return compared && diff.passes(exact);
  }
};

OutcomeStatus statusOf(Verdict verdict);

/// Reports whether the outcome has a new picture that can become the reference.
bool canBeApproved(const Outcome& outcome);

/// Reports whether approving would change the reference: the new picture differs or, with `exact`, its storage
/// differs.
inline bool isToApprove(const Outcome& outcome, bool exact) {
  return canBeApproved(outcome) && !(outcome.status == OutcomeStatus::kIdentical && outcome.passes(exact));
}

/// Returns why an outcome fails, in figures and in words. Example: "largest difference 222 (limit 2); 87 pixels in
/// one place of 40x24 px at (460, 340)". Never empty.
std::string reasonOf(const Outcome& outcome);

/// Returns all statuses, in the order of countsText().
std::span<const OutcomeStatus> outcomeStatuses();

/// Returns the number of outcomes of each status: "60 identical, 2 near, 1 different".
std::string countsText(const std::vector<Outcome>& outcomes);

/// Returns the worst verdict of all outcomes; failures count as different.
Verdict verdictOf(const std::vector<Outcome>& outcomes);

std::ptrdiff_t countFailures(const std::vector<Outcome>& outcomes, bool exact);

/// Returns one outcome for each pair of files of two folders, and for each file that only one folder has. An
/// outcome names its maps if the request has map folders.
std::vector<Outcome> outcomesOf(const FolderDiff& diff, const std::filesystem::path& reference,
                                const std::filesystem::path& test, const DiffRequest& request);

/// Returns the outcome of one pair of files, named after the test's file.
Outcome outcomeOf(const PictureDiff& diff, const std::filesystem::path& reference,
                  const std::filesystem::path& test, const DiffRequest& request);

/// Describes how a new reference differs from the previous one: "approved, 12 pixels changed, largest 30, ...".
std::string approvalText(const Outcome& outcome);

/// Facts about a run that its reports need.
struct OutcomeReport {
  std::string suite;
  bool exact = false;                    ///< whether only identical pictures pass
  std::filesystem::path page;            ///< HTML report; empty if there is none
  std::string approve;                   ///< command that approves the tests whose names follow it; may be empty
  std::string approveBy;                 ///< command that approves all failures; replaces `approve`; may be empty
  std::filesystem::path attachmentRoot;  ///< root for relative attachment paths; empty for absolute paths
};

/// Returns a command-line argument that selects only the test with this name, escaped for the shell.
std::string approvalWord(const std::string& name);

/// Returns the command that approves all failures that can be approved; empty if there are none.
std::string approveCommand(const std::vector<Outcome>& outcomes, const OutcomeReport& report);

}  // namespace poinsot::compare
