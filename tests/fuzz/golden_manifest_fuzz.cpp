// SPDX-License-Identifier: Apache-2.0
#include "fuzz/input.h"
#include "scene/document/problem.h"
#include "suite/manifest.h"

// Parses the input as a golden.toml in a folder that does not exist.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    poinsot::suite::parseGoldenManifest(std::string(poinsot::fuzz::textOf({data, size})), "/nowhere/golden.toml");
  } catch (const poinsot::scene::SceneErrors& errors) {
    poinsot::fuzz::expectPrintable(errors.what());
  }
  return 0;
}
