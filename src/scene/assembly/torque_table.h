// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "physics/forcing.h"

namespace poinsot::scene {

/// Parses a torque against time from CSV. Each line is t,Nx,Ny,Nz in s and N·m, with ascending times. The first
/// line may be a header with these names; the last line end is optional.
/// @throws core::Error(kScene) naming the line: "line 3: expected four numbers t,Nx,Ny,Nz, got ...".
physics::TorqueHistory parseTorqueTable(std::string_view csv, bool linear);

}  // namespace poinsot::scene
