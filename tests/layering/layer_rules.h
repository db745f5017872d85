// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace poinsot::layering {

/// One folder of src/ and the folders it may include and link besides itself.
struct Layer {
  std::string name;
  std::vector<std::string> mayUse;
};

/// All layers, lowest rank first: a layer may use only layers before it.
const std::vector<Layer>& layers();

/// What is wrong under `src`, one line each: "render/a.cpp:3: render must not include physics/b.h".
struct Findings {
  std::vector<std::string> violations;
  int filesRead = 0;
  int includesRead = 0;
};
Findings checkSources(const std::filesystem::path& src);

}  // namespace poinsot::layering
