// SPDX-License-Identifier: Apache-2.0
#include "core/error.h"
#include "fuzz/input.h"
#include "text/math_setter.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    poinsot::text::setTex(poinsot::fuzz::textOf({data, size}));
  } catch (const poinsot::core::Error& error) {
    poinsot::fuzz::expectPrintable(error.what());
  }
  return 0;
}
