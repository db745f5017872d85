// SPDX-License-Identifier: Apache-2.0
#include "scene/camera_preset.h"
#include "scene/keys/key_tables.h"
#include "scene/keys/put.h"

namespace poinsot::scene {
namespace {

using enum ValueType;
using enum Dimension;

constexpr Range kAzimuth{
    .least = -360, .most = 360, .unit = "deg"};  // rejects most bare degrees, which count as radians
constexpr Range kElevation{.least = -90, .most = 90, .unit = "deg"};
constexpr Range kFov{.least = 1, .most = 120, .unit = "deg"};
constexpr Range kOrbit{.least = -36000, .most = 36000, .unit = "deg"};
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
           .help = "In place of frame: panels side by side at the same instant, one for each frame.",
           .put = into([](Draft& d) { return &d.frames; })}};
}

std::vector<Key> cameraKeys() {
  return {
      {.path = "camera.preset",
       .type = kWord,
       .words = presetWords(),
       .example = "\"front\"",
       .help =
           "Sets azimuth and elevation where these are not given: front has x to the right and z up, side y to "
           "the right, top y up; low is just above the plane, high far above it; isometric sets the projection "
           "too.",
       .put = into([](Draft& d) { return &d.preset; })},
      {.path = "camera.projection",
       .type = kWord,
       .words = {"perspective", "orthographic"},
       .fallback = "\"perspective\"",
       .example = "\"orthographic\"",
       .help = "orthographic keeps parallels parallel and equal lengths equal, as in a technical drawing.",
       .put = into([](Draft& d) { return &d.scene.camera.projection; })},
      {.path = "camera.azimuth",
       .dimension = kAngle,
       .range = kAzimuth,
       .fallback = "\"22 deg\"",
       .example = "\"-120 deg\"",
       .help = "Where the camera stands about the world's vertical, from its x axis. Of a thrown body it stands "
               "beside the path unless this is given.",
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
       .help = "Vertical field of view in perspective: small is flat, as from afar.",
       .put = into([](Draft& d) { return &d.scene.camera.fov_rad; })},
      {.path = "camera.zoom",
       .range = kZoom,
       .fallback = "1",
       .example = "1.25",
       .help = "1 frames the whole motion, 2 shows it twice as large.",
       .put = into([](Draft& d) { return &d.scene.camera.zoom; })},
      {.path = "camera.orbit",
       .dimension = kAngle,
       .range = kOrbit,
       .fallback = "0",
       .example = "\"20 deg\"",
       .help = "By how much the camera turns about the vertical in the course of the film, steadily.",
       .put = into([](Draft& d) { return &d.scene.camera.orbit_rad; })},
      {.path = "camera.frame",
       .type = kWord,
       .words = kFrames,
       .fallback = "\"space\"",
       .example = "\"body\"",
       .help = "Which axes stand still in the picture: inertial ones, the body's, or those that turn about L with "
               "the axis of a symmetric body.",
       .put = into([](Draft& d) { return &d.scene.camera.frame; })},
      {.path = "camera.follow",
       .type = kBool,
       .fallback = "false",
       .example = "true",
       .help =
           "The camera goes along with a thrown body, as near as the body allows, and its path passes by; else "
           "it stands still and holds the whole flight.",
       .put = into([](Draft& d) { return &d.scene.camera.follow; })},
  };
}

}  // namespace poinsot::scene
