// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "scene/scene.h"

namespace poinsot::scene {

/// Named direction of a camera. If the scene gives an azimuth or an elevation, the preset's value is not used.
struct CameraPreset {
  std::string_view name;
  double azimuth_deg, elevation_deg;
  std::optional<Projection> projection{};
};

std::span<const CameraPreset> cameraPresets();

}  // namespace poinsot::scene
