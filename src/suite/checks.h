// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "suite/suite.h"

namespace poinsot::suite {

/// Checks that the manifest has references of each requested variant, because an unknown variant is probably
/// misspelt. A manifest without references of any variant passes.
/// @param approveBy  command that approves the first reference of a variant, for the message
/// @throws core::Error(kUsage) for an unknown variant
void expectKnownVariants(const GoldenManifest& manifest, const GoldenRequest& request,
                         const std::string& approveBy);

/// Enters the patterns of scenes and images as inputs, so that the run writes no file that a pattern would match
/// at the next run. @param manifest  must outlive `files`
void enterPatterns(output::RunFiles& files, const GoldenManifest& manifest);

/// Checks that no two files of a suite coincide: references and their descriptions, images and masks, new pictures
/// and maps. Links among the folders are followed. Case is ignored if the file system of the references or of
/// `output` ignores it.
/// @param cases  all cases of the manifest
/// @throws scene::SceneErrors with both tests and their lines; core::Error(kUsage) if another `output` is the
///   remedy
void expectFilesApart(const GoldenManifest& manifest, const std::vector<GoldenCase>& cases,
                      const std::filesystem::path& output);

}  // namespace poinsot::suite
