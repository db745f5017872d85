// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "scene/scene.h"

namespace poinsot::scene {

/// Where a camera stands, by a word; an explicit azimuth or elevation wins.
struct CameraPreset {
  std::string_view name;
  double azimuth_deg, elevation_deg;
  std::optional<Projection> projection{};
};

std::span<const CameraPreset> cameraPresets();

}  // namespace poinsot::scene
