// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "physics/forcing.h"

namespace poinsot::scene {

/// Parses a torque as a function of time from CSV. Each line is t,Nx,Ny,Nz in s and N·m, with ascending times. The
/// first line may be a header with these names. The last line may end without a newline.
/// @param linear  whether the torque changes linearly between two lines; else it keeps the value of the earlier
/// line
/// @throws core::Error(kScene) naming the line: "line 3: expected four numbers t,Nx,Ny,Nz, got ...".
physics::TorqueHistory parseTorqueTable(std::string_view csv, bool linear);

}  // namespace poinsot::scene
