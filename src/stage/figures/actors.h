// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "stage/figures/actor.h"

namespace poinsot::stage {

/// A drawn thing under the name that it has in a scene: "L" for what show.L asks for.
struct ShownActor {
  std::string_view name;
  std::unique_ptr<const Actor> actor;
};

/// All that a view shows.
/// @throws core::Error(kScene) for what the motion does not have.
std::vector<ShownActor> makeActors(const Setting& setting);

/// Whether something of Poinsot's construction is shown, and there is one.
bool showsConstruction(const scene::Show& show, const PictureMotion& motion);

}  // namespace poinsot::stage
