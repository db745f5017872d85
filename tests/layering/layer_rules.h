// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace poinsot::layering {

/// Folder of src/, and the other folders that it may include and link.
struct Layer {
  std::string name;
  std::vector<std::string> mayUse;
};

/// Returns all layers, lowest rank first; a layer may use only layers before it.
const std::vector<Layer>& layers();

/// Result of a check: violations, one line each ("render/a.cpp:3: render must not include physics/b.h"), and how
/// much was read.
struct Findings {
  std::vector<std::string> violations;
  int filesRead = 0;
  int includesRead = 0;
};
Findings checkSources(const std::filesystem::path& src);

}  // namespace poinsot::layering
