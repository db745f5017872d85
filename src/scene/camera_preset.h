// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "scene/scene.h"

namespace poinsot::scene {

/// Named position of a camera. An explicit azimuth or elevation overrides the preset.
struct CameraPreset {
  std::string_view name;
  double azimuth_deg, elevation_deg;
  std::optional<Projection> projection{};
};

std::span<const CameraPreset> cameraPresets();

}  // namespace poinsot::scene
