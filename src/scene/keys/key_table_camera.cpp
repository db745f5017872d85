// SPDX-License-Identifier: Apache-2.0
#include "scene/camera_preset.h"
#include "scene/keys/key_tables.h"
#include "scene/keys/put.h"

namespace poinsot::scene {
namespace {

using enum ValueType;
using enum Dimension;

constexpr Range kAzimuth{
    .least = -360, .most = 360, .unit = "deg"};  // rejects most degrees without a unit, which count as radians
constexpr Range kElevation{.least = -90, .most = 90, .unit = "deg"};
constexpr Range kFov{.least = 1, .most = 120, .unit = "deg"};
constexpr Range kOrbit{.least = -36000, .most = 36000, .unit = "deg"};
constexpr Range kShift{.least = -1, .most = 1};
constexpr Range kZoom{.least = 0.05, .most = 20};

const std::vector<std::string_view> kFrames = {"space", "body", "precession"};

std::vector<std::string_view> presetWords() {
  std::vector<std::string_view> words;
  for (const CameraPreset& preset : cameraPresets()) words.push_back(preset.name);
  return words;
}

}  // namespace

std::vector<Key> framesKeys() {
  return {{.path = "camera.frames",
           .type = kWords,
           .words = kFrames,
           .example = "[\"space\", \"body\"]",
           .help = "Several frames of reference for one picture, such as `space` and `body`. The picture has one "
                   "panel for each of them, side by side, and all panels show the same instant. Use this key "
                   "instead of `frame`.",
           .put = into([](Draft& d) { return &d.frames; })}};
}

std::vector<Key> cameraKeys() {
  return {
      {.path = "camera.shift",
       .type = kPair,
       .range = kShift,
       .fallback = "[0, 0]",
       .example = "[0.15, 0]",
       .help = "Shift of what the camera sees, to the right and up, as fractions of the panel's width and height. "
               "It makes room beside the body, for text of your own.",
       .put =
           [](Draft& d, std::size_t, const Checked& value) {
             const auto& shift = std::get<std::vector<double>>(value);
             d.scene.camera.shift = {shift[0], shift[1]};
           }},
      {.path = "camera.preset",
       .type = kWord,
       .words = presetWords(),
       .example = "\"front\"",
       .help = "Named viewpoint of the camera. The preset sets azimuth and elevation unless the scene gives them. "
               "`front` has x to the right and z up, `side` has y to the right, and `top` has y up. `low` is just "
               "above the invariable plane, and `high` is far above it. `isometric` also sets the projection.",
       .put = into([](Draft& d) { return &d.preset; })},
      {.path = "camera.projection",
       .type = kWord,
       .words = {"perspective", "orthographic"},
       .fallback = "\"perspective\"",
       .example = "\"orthographic\"",
       .help = "Projection of the camera. `orthographic` keeps parallel lines parallel and equal lengths equal, "
               "as in a technical drawing.",
       .put = into([](Draft& d) { return &d.scene.camera.projection; })},
      {.path = "camera.azimuth",
       .dimension = kAngle,
       .range = kAzimuth,
       .fallback = "\"22 deg\"",
       .example = "\"-120 deg\"",
       .help = "Angle about the world's vertical, from the x axis, at which the camera stands. For a thrown body, "
               "the default is a camera beside the path of the flight.",
       .put = into([](Draft& d) { return &d.scene.camera.azimuth_rad; })},
      {.path = "camera.elevation",
       .dimension = kAngle,
       .range = kElevation,
       .fallback = "\"18 deg\"",
       .example = "\"30 deg\"",
       .help = "Angle of the camera above the horizontal.",
       .put = into([](Draft& d) { return &d.scene.camera.elevation_rad; })},
      {.path = "camera.fov",
       .dimension = kAngle,
       .range = kFov,
       .fallback = "\"24 deg\"",
       .example = "\"40 deg\"",
       .help = "Vertical field of view of the camera in perspective. With a small angle, the picture looks flat, "
               "as if seen from far away.",
       .put = into([](Draft& d) { return &d.scene.camera.fov_rad; })},
      {.path = "camera.zoom",
       .range = kZoom,
       .fallback = "1",
       .example = "1.25",
       .help = "Magnification of the picture: 1 frames the whole motion, 2 shows it twice as large.",
       .put = into([](Draft& d) { return &d.scene.camera.zoom; })},
      {.path = "camera.orbit",
       .dimension = kAngle,
       .range = kOrbit,
       .fallback = "0",
       .example = "\"20 deg\"",
       .help = "Angle by which the camera turns steadily about the vertical during the film.",
       .put = into([](Draft& d) { return &d.scene.camera.orbit_rad; })},
      {.path = "camera.frame",
       .type = kWord,
       .words = kFrames,
       .fallback = "\"space\"",
       .example = "\"body\"",
       .help = "Frame of reference that stands still in the picture. `space` is inertial, `body` is fixed in the "
               "body, and `precession` turns about L with the axis of a symmetric body.",
       .put = into([](Draft& d) { return &d.scene.camera.frame; })},
      {.path = "camera.follow",
       .type = kBool,
       .fallback = "false",
       .example = "true",
       .help = "Whether the camera moves with a thrown body. If true, the camera is as near as the size of the "
               "body allows, and the path of the flight passes by. If false, the camera stands still and frames "
               "the whole flight.",
       .put = into([](Draft& d) { return &d.scene.camera.follow; })},
  };
}

}  // namespace poinsot::scene
