// SPDX-License-Identifier: Apache-2.0
#pragma once

// The version of the headers, for #if. CMake reads it from these three lines: it is written nowhere else.
#define POINSOT_VERSION_MAJOR 0
#define POINSOT_VERSION_MINOR 1
#define POINSOT_VERSION_PATCH 0

/// Makes one number of a version, which grows with it: POINSOT_VERSION >= POINSOT_MAKE_VERSION(0, 2, 0).
#define POINSOT_MAKE_VERSION(major, minor, patch) ((major)*1000000 + (minor)*1000 + (patch))
#define POINSOT_VERSION POINSOT_MAKE_VERSION(POINSOT_VERSION_MAJOR, POINSOT_VERSION_MINOR, POINSOT_VERSION_PATCH)

namespace poinsot::core {

/// Returns "0.1.0", the version of the library that is linked.
const char* version();

}  // namespace poinsot::core
