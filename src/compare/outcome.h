// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "compare/folder_diff.h"
#include "compare/picture_diff.h"
#include "compare/picture_origin.h"

namespace poinsot::compare {

enum class OutcomeStatus {
  kIdentical,
  kNear,
  kDifferent,
  kNew,      ///< there is no reference
  kMissing,  ///< there is only a reference
  kUnused,   ///< approved, and no test makes it
  kError     ///< a picture that cannot be made or read
};

/// "identical", "near", "different", "new", "missing", "unused", "error".
std::string_view toString(OutcomeStatus status);

/// Result of one test: of a case of a suite, or of a pair of pictures or films.
struct Outcome {
  std::string name;
  OutcomeStatus status = OutcomeStatus::kError;
  std::string message;                    ///< why it is no pass, or near; then originChange()
  PictureDiff diff;                       ///< against `reference`; figures where both could be compared
  std::filesystem::path reference;        ///< the nearest of those approved; empty if none
  PictureOrigin approved;                 ///< of the reference
  std::filesystem::path actual;           ///< the new picture; empty if there is none
  std::string pixels;                     ///< pixelDigest() of the new picture of a suite; empty if there is none
  std::filesystem::path map, difference;  ///< files that were written of it; empty if none
  PictureOrigin origin;                   ///< of the new picture
  PictureRule rule;                       ///< that it was held to
  double seconds = 0;                     ///< of comparing

  bool passes(bool exact) const {
    const bool compared = status == OutcomeStatus::kIdentical || status == OutcomeStatus::kNear;
    return compared && diff.passes(exact);
  }
};

OutcomeStatus statusOf(Verdict verdict);

/// Whether there is a new picture that can become the reference.
bool canBeApproved(const Outcome& outcome);

/// Whether approving would change the reference: a new picture differs from it, or, with `exact`, is stored in
/// another way.
inline bool isToApprove(const Outcome& outcome, bool exact) {
  return canBeApproved(outcome) && !(outcome.status == OutcomeStatus::kIdentical && outcome.passes(exact));
}

/// Why an outcome is no pass, in figures and in words: "largest difference 222 (limit 2); 87 pixels in one place
/// of 40x24 px at (460, 340)". Never empty.
std::string reasonOf(const Outcome& outcome);

/// How many outcomes have each status: "60 identical, 2 near, 1 different".
std::string countsText(const std::vector<Outcome>& outcomes);

/// The verdict of all together: that of the worst.
Verdict verdictOf(const std::vector<Outcome>& outcomes);

std::ptrdiff_t countFailures(const std::vector<Outcome>& outcomes, bool exact);

/// The pairs of two folders, and what has no partner. Maps are named where the request asks for them.
std::vector<Outcome> outcomesOf(const FolderDiff& diff, const std::filesystem::path& reference,
                                const std::filesystem::path& test, const DiffRequest& request);

/// One pair of files, called by the file name of the test.
Outcome outcomeOf(const PictureDiff& diff, const std::filesystem::path& reference,
                  const std::filesystem::path& test, const DiffRequest& request);

/// How far a new reference is from the one before: "approved, 12 pixels changed, largest 30, ...".
std::string approvalText(const Outcome& outcome);

/// Facts about a run for the reports of its outcomes.
struct OutcomeReport {
  std::string suite;           ///< name of all tests together
  bool exact = false;          ///< only identical pictures pass
  std::filesystem::path page;  ///< report with pictures; empty if there is none
  std::string approve;         ///< command that approves the tests whose names follow; empty if there is none
  std::string approveBy;       ///< in place of that, command that approves all failures; empty if there is none
  std::filesystem::path attachmentRoot;  ///< folder from which paths of attachments are; empty: absolute paths
};

/// The word of a command line that means a test of this name and no other.
std::string approvalWord(const std::string& name);

/// The command that approves all failures that can be approved; empty if there are none.
std::string approveCommand(const std::vector<Outcome>& outcomes, const OutcomeReport& report);

}  // namespace poinsot::compare
