// SPDX-License-Identifier: Apache-2.0
#include "core/version.h"

#define POINSOT_TEXT_OF(number) #number
#define POINSOT_DOTTED(major, minor, patch) \
  POINSOT_TEXT_OF(major) "." POINSOT_TEXT_OF(minor) "." POINSOT_TEXT_OF(patch)

namespace poinsot::core {

const char* version() {
  return POINSOT_DOTTED(POINSOT_VERSION_MAJOR, POINSOT_VERSION_MINOR, POINSOT_VERSION_PATCH);
}

}  // namespace poinsot::core
