// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/outcome.h"
#include "core/file_batch.h"

namespace poinsot::compare {

/// Result of addApprovals(): text with one line per picture, and whether all requested pictures could be approved.
struct PairApproval {
  std::string text;
  bool complete = true;
};

/// Checks, before a comparison, that the reference's pictures can be replaced.
/// @param reference  file or folder
/// @throws core::Error(kIo) with the path and the reason
void expectReplaceable(const std::filesystem::path& reference);

/// Returns the files that approve the new picture of an outcome.
/// @param reference  reference picture, or folder for pictures that have no reference yet
std::vector<ApprovalFile> approvalOf(const Outcome& outcome, const std::filesystem::path& reference);

/// Approves new pictures: adds copies of them to a batch, which then replaces the reference pictures. Copies the
/// pictures that are not identical and whose names match a pattern (* for any characters). A picture that cannot
/// be read, or that only the reference has, is left unchanged and makes the approval incomplete.
/// @param reference  folder for pictures that have no reference yet
/// @param exact  whether to copy pictures that differ only in storage format
/// @throws core::Error(kUsage) if a pattern matches no outcome; core::Error(kIo) if a picture cannot be copied, or
///   if a folder between the reference folder and a picture is a link
PairApproval addApprovals(core::FileBatch& batch, const std::vector<Outcome>& outcomes,
                          const std::vector<std::string>& patterns, const std::filesystem::path& reference,
                          bool exact);

}  // namespace poinsot::compare
