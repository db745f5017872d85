// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "cli/scene_options.h"

namespace poinsot::cli {

/// A picture is approved by somebody who looked at it.
/// @throws core::Error(kUsage) where the environment says CI, and for what is not trusted.
void expectMayApprove(const AllowanceOptions& options);

/// Folder from which a CI server takes paths of attachments: GitLab's CI_PROJECT_DIR. Empty elsewhere: Jenkins
/// takes absolute paths.
std::filesystem::path attachmentRoot();

}  // namespace poinsot::cli
