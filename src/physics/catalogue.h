// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "physics/mass_properties.h"
#include "physics/principal_moments.h"

namespace poinsot::physics {

/// Tone of a mark on a body: darker or lighter than the body.
enum class MarkTone { kDark, kLight };

/// Coloured shape on a body, such as the camera of a phone. It has no mass and is only drawn.
struct SolidMark {
  SolidPart part;
  MarkTone tone = MarkTone::kDark;
};

/// Real body, such as a football or an asteroid, with its mass properties and their sources.
struct CatalogueBody {
  std::string name;  ///< identifier of the body in scene files
  std::string title;
  double mass_kg = 0;
  std::vector<SolidPart> parts;  ///< solids of the body; used only for drawing if `moments` is set
  /// Moments that replace the moments of `parts`, such as measured moments or those of a closed hull. They are
  /// about the body's own axes, whose origin is the centre of mass.
  std::optional<PrincipalMoments> moments;
  std::string source;  ///< which numbers are published, computed or assumed, and where they come from
  std::vector<SolidMark> marks = {};  ///< marks that show how the body has turned
};

/// Returns all bodies in the order of the lecture, from hand-held objects to celestial bodies.
const std::vector<CatalogueBody>& catalogue();

/// Returns the body with this name, or nullptr if there is none.
const CatalogueBody* findCatalogueBody(std::string_view name);

/// Returns the mass properties from `moments` if they are set, otherwise from the parts.
MassProperties massProperties(const CatalogueBody& body);

}  // namespace poinsot::physics
