// SPDX-License-Identifier: Apache-2.0
#include "scene/catalogue_mass.h"

#include "physics/catalogue.h"

namespace poinsot::scene {

std::optional<double> catalogueMass_kg(std::string_view name) {
  const physics::CatalogueBody* body = physics::findCatalogueBody(name);
  return body ? std::optional(body->mass_kg) : std::nullopt;
}

}  // namespace poinsot::scene
