// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/outcome.h"
#include "core/file_batch.h"

namespace poinsot::compare {

/// Approved pictures, one line each, and whether everything requested could be approved.
struct PairApproval {
  std::string text;
  bool complete = true;
};

/// Checks, before comparing, that the reference's pictures can be replaced. @param reference  file or folder
/// @throws core::Error(kIo) with the path and the reason
void expectReplaceable(const std::filesystem::path& reference);

/// Adds copies of the test's pictures to a batch that replaces reference pictures. Copies the pictures that are
/// not identical and whose names match a pattern (* for any characters). Pictures that cannot be read, or that
/// only the reference has, stay unchanged and make the approval incomplete.
/// @param reference  folder for new pictures
/// @param exact  whether to copy pictures that differ only in storage format
/// @throws core::Error(kUsage) if a pattern matches no outcome; core::Error(kIo), also for links among the folders
///   below the reference's
PairApproval addApprovals(core::FileBatch& batch, const std::vector<Outcome>& outcomes,
                          const std::vector<std::string>& patterns, const std::filesystem::path& reference,
                          bool exact);

}  // namespace poinsot::compare
