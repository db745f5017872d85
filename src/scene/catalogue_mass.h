// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

namespace poinsot::scene {

/// Returns the mass of a body of body.catalogue. Returns nullopt if the catalogue has no body of this name.
std::optional<double> catalogueMass_kg(std::string_view name);

}  // namespace poinsot::scene
