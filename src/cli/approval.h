// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "cli/scene_options.h"

namespace poinsot::cli {

/// Checks that pictures may be approved. A CI job must not approve any, because nobody looks at them.
/// @throws core::Error(kUsage) if the environment variable CI is set, or with --untrusted
void expectMayApprove(const AllowanceOptions& options);

/// Returns the folder from which a CI server resolves paths of attachments: GitLab's CI_PROJECT_DIR. Empty if the
/// variable is not set, as on Jenkins, which takes absolute paths.
std::filesystem::path attachmentRoot();

}  // namespace poinsot::cli
