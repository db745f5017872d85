// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "cli/scene_options.h"

namespace poinsot::cli {

/// Checks that the user may approve pictures. A CI job may not, because nobody looks at its pictures.
/// @param what  start of the message
/// @throws core::Error(kUsage) if the environment variable CI is set, or with --untrusted
void expectMayApprove(const AllowanceOptions& options, const char* what = "--update");

/// Returns the folder to which paths of attachments in JUnit reports are relative: CI_PROJECT_DIR on GitLab. Empty
/// if the variable is not set, for example on Jenkins, which accepts absolute paths.
std::filesystem::path attachmentRoot();

}  // namespace poinsot::cli
