// SPDX-License-Identifier: Apache-2.0
#include "scene/key_tables.h"
#include "scene/put.h"

namespace poinsot::scene {
namespace {

using enum ValueType;
using enum Dimension;

constexpr Range kAzimuth{
    .least = -360, .most = 360, .unit = "deg"};  // bare degrees, read as radians, fall outside
constexpr Range kElevation{.least = -89, .most = 89, .unit = "deg"};  // at 90 no direction is up in the picture
constexpr Range kFov{.least = 1, .most = 120, .unit = "deg"};
constexpr Range kZoom{.least = 0.05, .most = 20};

}  // namespace

std::vector<Key> cameraKeys() {
  return {
      {.path = "camera.azimuth",
       .dimension = kAngle,
       .range = kAzimuth,
       .fallback = "\"22 deg\"",
       .example = "\"-120 deg\"",
       .help = "Where the camera stands about the world's vertical, from its x axis.",
       .put = into([](Draft& d) { return &d.scene.camera.azimuth_rad; })},
      {.path = "camera.elevation",
       .dimension = kAngle,
       .range = kElevation,
       .fallback = "\"18 deg\"",
       .example = "\"30 deg\"",
       .help = "How far the camera stands above the horizontal.",
       .put = into([](Draft& d) { return &d.scene.camera.elevation_rad; })},
      {.path = "camera.fov",
       .dimension = kAngle,
       .range = kFov,
       .fallback = "\"24 deg\"",
       .example = "\"40 deg\"",
       .help = "Vertical field of view: small is flat, as from afar.",
       .put = into([](Draft& d) { return &d.scene.camera.fov_rad; })},
      {.path = "camera.zoom",
       .range = kZoom,
       .fallback = "1",
       .example = "1.25",
       .help = "1 frames the whole motion, 2 shows it twice as large.",
       .put = into([](Draft& d) { return &d.scene.camera.zoom; })},
      {.path = "camera.frame",
       .type = kWord,
       .words = {"space", "body"},
       .fallback = "\"space\"",
       .example = "\"body\"",
       .help = "Which axes stand still in the picture.",
       .put = into([](Draft& d) { return &d.scene.camera.frame; })},
  };
}

}  // namespace poinsot::scene
