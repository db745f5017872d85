// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "suite/suite.h"

namespace poinsot::suite {

/// Checks that each requested variant has references in the manifest, because an unknown variant is probably
/// misspelt. A manifest without references of any variant passes.
/// @param approveBy  command that approves the first reference of a variant, for the error message
/// @throws core::Error(kUsage) for an unknown variant
void expectKnownVariants(const GoldenManifest& manifest, const GoldenRequest& request,
                         const std::string& approveBy);

/// Registers the patterns of scenes and images as inputs of a run. The run can then write no file that one of the
/// patterns would match in the next run.
/// @param manifest  must outlive `files`
void enterPatterns(output::RunFiles& files, const GoldenManifest& manifest);

/// Checks that no file of a suite has two uses, such as a reference that is also a new picture. Covers references
/// and their descriptions, images and masks, new pictures and maps. Links to folders are followed. Names that
/// differ only in case are equal if the file system of the references or of `output` ignores case.
/// @param cases  all cases of the manifest
/// @throws scene::SceneErrors with both tests and their lines; core::Error(kUsage) if another `output` solves the
///   problem
void expectFilesApart(const GoldenManifest& manifest, const std::vector<GoldenCase>& cases,
                      const std::filesystem::path& output);

}  // namespace poinsot::suite
