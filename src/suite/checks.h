// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "suite/suite.h"

namespace poinsot::suite {

/// Checks that for the variant of each case that is asked for, a reference of some case of the manifest was
/// approved, if references of any variant were: another one is probably a slip.
/// @param approveBy  words or command that approves the first reference of a variant, for the message
/// @throws core::Error(kUsage)
void expectKnownVariants(const GoldenManifest& manifest, const GoldenRequest& request,
                         const std::string& approveBy);

/// Enters the patterns of scenes and images: a file that the run writes must be none that a pattern takes up at
/// the next run. @param manifest  lives as long as `files`
void enterPatterns(output::RunFiles& files, const GoldenManifest& manifest);

/// Checks that no two files of a suite are one: references and their descriptions, images and masks, new pictures
/// and maps. Folders are compared with their links followed. Letters in capitals or not are the same where the
/// file system of the references or of `output` takes them so.
/// @param cases  all of the manifest
/// @throws scene::SceneErrors with both tests and their lines; (kUsage) where another `output` helps.
void expectFilesApart(const GoldenManifest& manifest, const std::vector<GoldenCase>& cases,
                      const std::filesystem::path& output);

}  // namespace poinsot::suite
