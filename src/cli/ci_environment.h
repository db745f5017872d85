// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace poinsot::cli {

/// Folder from which a CI server takes paths of attachments: GitLab's CI_PROJECT_DIR. Empty elsewhere: Jenkins
/// takes absolute paths.
std::filesystem::path attachmentRoot();

}  // namespace poinsot::cli
