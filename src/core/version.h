// SPDX-License-Identifier: Apache-2.0
#pragma once

// Version of the headers, for use in #if. CMake reads these three lines, the only place with the version.
#define POINSOT_VERSION_MAJOR 0
#define POINSOT_VERSION_MINOR 1
#define POINSOT_VERSION_PATCH 0

/// Combines a version into one number, for comparisons such as POINSOT_VERSION >= POINSOT_MAKE_VERSION(0, 2, 0).
#define POINSOT_MAKE_VERSION(major, minor, patch) ((major)*1000000 + (minor)*1000 + (patch))
#define POINSOT_VERSION POINSOT_MAKE_VERSION(POINSOT_VERSION_MAJOR, POINSOT_VERSION_MINOR, POINSOT_VERSION_PATCH)

namespace poinsot::core {

/// Returns the version of the linked library, such as "0.1.0".
const char* version();

}  // namespace poinsot::core
