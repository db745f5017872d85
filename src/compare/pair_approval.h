// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/outcome.h"
#include "core/file_batch.h"

namespace poinsot::compare {

/// Approved pictures, a line for each, and whether all that was asked for could be approved.
struct PairApproval {
  std::string text;
  bool complete = true;
};

/// Checks that pictures of a reference can be replaced, before any are compared. @param reference  a file or
/// folder
/// @throws core::Error(kIo) with the path and the reason.
void expectReplaceable(const std::filesystem::path& reference);

/// Adds copies of pictures of the test, for the places of those of the reference: of the outcomes whose names the
/// patterns mean (* for any characters), those that are not identical. Pictures that cannot be read and
/// those that only the reference has stay as they are, and make the approval incomplete.
/// @param reference  folder for pictures that are new
/// @param exact  whether pictures that are only stored in another way are copied, too
/// @throws core::Error(kUsage) for a pattern that means no outcome; core::Error(kIo), also for a
/// link among the folders below the reference's.
PairApproval addApprovals(core::FileBatch& batch, const std::vector<Outcome>& outcomes,
                          const std::vector<std::string>& patterns, const std::filesystem::path& reference,
                          bool exact);

}  // namespace poinsot::compare
