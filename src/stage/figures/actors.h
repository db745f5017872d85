// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "stage/figures/actor.h"

namespace poinsot::stage {

/// Object drawn in a view, with its name in a scene, such as "L" for the object that show.L sets.
struct ShownActor {
  std::string_view name;
  std::unique_ptr<const Actor> actor;
};

/// Returns the actors for everything that a view shows.
/// @throws core::Error(kScene) if the view shows something that the motion does not have.
std::vector<ShownActor> makeActors(const Setting& setting);

/// Returns true if any part of Poinsot's construction is shown and the body is not at rest all the time.
bool showsConstruction(const scene::Show& show, const PictureMotion& motion);

}  // namespace poinsot::stage
