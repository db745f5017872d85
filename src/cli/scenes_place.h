// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace poinsot::cli {

/// Where scenes are looked for without being told: the folder POINSOT_SCENES (the launcher names that of its
/// checkout), the one that was installed with the program, or scenes/ here.
std::string scenesPlace();

}  // namespace poinsot::cli
