// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/golden_suite.h"

namespace poinsot::app {

/// Checks that for the variant of each case that is asked for, a reference of some case of the manifest was
/// approved, if references of any variant were: another one is probably a slip.
/// @param approveBy  words or command that approves the first reference of a variant, for the message
/// @throws core::Error(kUsage)
void expectKnownVariants(const GoldenManifest& manifest, const GoldenRequest& request,
                         const std::string& approveBy);

/// Checks that nothing that a run writes into `output` replaces a reference. @throws core::Error(kUsage)
void expectReferencesKept(const std::vector<GoldenCase>& cases, const std::filesystem::path& references,
                          const std::filesystem::path& output);

/// Checks that no map that a run writes into `output` replaces an image that is compared.
/// @throws core::Error(kUsage)
void expectImagesKept(const std::vector<GoldenCase>& cases, const std::filesystem::path& output);

}  // namespace poinsot::app
