// SPDX-License-Identifier: Apache-2.0
#include "core/error.h"
#include "fuzz/input.h"
#include "scene/assembly/torque_table.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    poinsot::scene::parseTorqueTable(poinsot::fuzz::textOf({data, size}), true);
  } catch (const poinsot::core::Error& error) {
    poinsot::fuzz::expectPrintable(error.what());
  }
  return 0;
}
