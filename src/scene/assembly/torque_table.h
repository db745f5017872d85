// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "physics/forcing.h"

namespace poinsot::scene {

/// Reads a torque against time from CSV: each line t,Nx,Ny,Nz in s and N·m, times ascending; a first line with
/// just these names may stand above, and the last line may end without a line end.
/// @throws core::Error(kScene) naming the line: "line 3: expected four numbers t,Nx,Ny,Nz, got ...".
physics::TorqueHistory parseTorqueTable(std::string_view csv, bool linear);

}  // namespace poinsot::scene
