// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "physics/mass_properties.h"
#include "physics/principal_moments.h"

namespace poinsot::physics {

/// A body of the real world.
struct CatalogueBody {
  std::string name;   ///< as a scene file has it
  std::string title;  ///< for people
  double mass_kg = 0;
  std::vector<SolidPart> parts;             ///< what it is made of; with `moments`, only what it looks like
  std::optional<PrincipalMoments> moments;  ///< measured, or of a hull that is closed; about its own axes,
                                            ///< origin at the centre of mass
  std::string source;  ///< where each number is from: published, computed from what, or assumed
};

/// All bodies, in the order of the lecture: from the hand to the sky.
const std::vector<CatalogueBody>& catalogue();

/// Null if there is none of that name.
const CatalogueBody* findCatalogueBody(std::string_view name);

/// From the measured moments if there are any, else from the parts.
MassProperties massProperties(const CatalogueBody& body);

}  // namespace poinsot::physics
