// SPDX-License-Identifier: Apache-2.0
#include "scene/camera_preset.h"

namespace poinsot::scene {

std::span<const CameraPreset> cameraPresets() {
  // Directions of technical drawings. In the front view, x points right and z up. In the top view, x points right
  // and y up. The isometric view shortens all axes equally; 35.264 degrees = atan(1 / sqrt 2).
  static constexpr CameraPreset kPresets[] = {
      {"front", -90, 0},    {"back", 90, 0},     {"side", 0, 0},
      {"right", 0, 0},      {"left", 180, 0},    {"top", -90, 90},
      {"bottom", -90, -90}, {"raised", -90, 18}, {"three_quarter", -55, 20},
      {"low", 22, 6},       {"high", 22, 50},    {"isometric", -45, 35.26438968275466, Projection::kOrthographic}};
  return kPresets;
}

}  // namespace poinsot::scene
