// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "physics/mass_properties.h"
#include "physics/principal_moments.h"

namespace poinsot::physics {

/// Body of the real world, with its mass properties and their sources.
struct CatalogueBody {
  std::string name;  ///< identifier in scene files
  std::string title;
  double mass_kg = 0;
  std::vector<SolidPart> parts;  ///< solids of the body; with `moments` set, used only for drawing
  /// Moments that replace those of `parts`: measured ones, or those of a closed hull. They are about the body's
  /// own axes, with the origin at the centre of mass.
  std::optional<PrincipalMoments> moments;
  std::string source;  ///< origin of each number: published, computed or assumed
};

/// Returns all bodies in the order of the lecture, from objects in the hand to those in the sky.
const std::vector<CatalogueBody>& catalogue();

/// Returns the body with this name, or nullptr if there is none.
const CatalogueBody* findCatalogueBody(std::string_view name);

/// Returns the mass properties from `moments` if they are set, otherwise from the parts.
MassProperties massProperties(const CatalogueBody& body);

}  // namespace poinsot::physics
