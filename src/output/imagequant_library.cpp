// SPDX-License-Identifier: Apache-2.0
#include "output/imagequant_library.h"

#include "core/shared_library.h"

namespace poinsot::output {

Imagequant::Imagequant() {
  // The interface version is not in the header. It is 0 for every library that has these functions.
  const core::SharedLibrary library("libimagequant.so.0", "libimagequant0", core::ErrorKind::kEncode);
#define POINSOT_LOAD(function) library.load(function, #function);
  POINSOT_IMAGEQUANT_FUNCTIONS(POINSOT_LOAD)
  library.find(omp_set_num_threads, "omp_set_num_threads");
}

const Imagequant& imagequant() {
  static const Imagequant functions;
  return functions;
}

}  // namespace poinsot::output
