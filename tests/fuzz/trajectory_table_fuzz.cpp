// SPDX-License-Identifier: Apache-2.0
#include "core/error.h"
#include "fuzz/input.h"
#include "reference/grade_table.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    poinsot::reference::parseTrajectoryTable(poinsot::fuzz::textOf({data, size}), "theirs.csv");
  } catch (const poinsot::core::Error& error) {
    poinsot::fuzz::expectPrintable(error.what());
  }
  return 0;
}
