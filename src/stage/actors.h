// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "stage/actor.h"

namespace poinsot::stage {

/// What a view shows besides body, vectors and construction.
/// @throws core::Error(kScene) for what the motion does not have.
std::vector<std::unique_ptr<const Actor>> makeActors(const Setting& setting);

}  // namespace poinsot::stage
