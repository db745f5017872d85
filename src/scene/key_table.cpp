// SPDX-License-Identifier: Apache-2.0
#include "scene/keys.h"
#include "scene/limits.h"
#include "scene/put.h"

namespace poinsot::scene {
namespace {

using enum ValueType;
using enum Dimension;

// Ranges, each with its reason.

// Far beyond any body, and so that L^2 (below 1e201) and T neither under- nor overflow a double.
constexpr Range kMoments{.least = kLeastMoment, .most = kMostMoment};
constexpr Range kSpins{.least = 1e-40, .most = 1e40, .ofSize = true};  // each part may be zero
constexpr Range kInstants{.least = -1e20, .most = 1e20};               // times the spin it is an angle
constexpr Range kExtent{.least = 1e-12, .most = 1e12};                 // what is drawn is cast to float in the end
constexpr Range kScale{.least = 0.01, .most = 100};
constexpr Range kOpacity{.least = 0, .most = 1};
constexpr Range kAzimuth{
    .least = -360, .most = 360, .unit = "deg"};  // bare degrees, read as radians, fall outside
constexpr Range kElevation{.least = -89, .most = 89, .unit = "deg"};  // at 90 no direction is up in the picture
constexpr Range kFov{.least = 1, .most = 120, .unit = "deg"};
constexpr Range kZoom{.least = 0.05, .most = 20};
constexpr Range kFactor{.least = 0.1, .most = 10};
constexpr Range kQuaternionNorm{.least = 1e-6, .most = 1e6};

std::vector<std::string_view> shapeWords() { return {"box", "ellipsoid", "cylinder", "racket"}; }

std::vector<std::string_view> qualityWords() {
  std::vector<std::string_view> words;
  for (const QualityPreset& preset : qualityPresets()) words.push_back(preset.name);
  return words;
}

Key visibleKey(std::string_view path, std::string_view help, std::function<void(Draft&, const Checked&)> put) {
  return {
      .path = path, .type = kBool, .fallback = "true", .example = "false", .help = help, .put = std::move(put)};
}

Key scaleKey(std::string_view path, std::string_view help, std::function<void(Draft&, const Checked&)> put) {
  return {.path = path, .range = kScale, .fallback = "1", .example = "1.5", .help = help, .put = std::move(put)};
}

Key opacityKey(std::string_view path, std::string_view fallback, std::function<void(Draft&, const Checked&)> put) {
  return {.path = path,
          .range = kOpacity,
          .fallback = fallback,
          .example = "0.3",
          .help = "How much of what lies behind it hides: 0 nothing, 1 all.",
          .put = std::move(put)};
}

std::vector<Key> makeKeys() {
  return {
      {.path = "schema",
       .type = kInteger,
       .range = {.least = 1, .most = 1},
       .fallback = "1",
       .example = "1",
       .help = "Version of this format; only 1 exists.",
       .put = [](Draft&, const Checked&) {}},

      {.path = "body.principal_moments",
       .type = kVector,
       .dimension = kMomentOfInertia,
       .range = kMoments,
       .example = "[1.0, 2.0, 2.5]",
       .help = "Moments of inertia about the body's principal axes, in any order; none above the sum of the "
               "others. This, or shape, size and mass.",
       .put = into([](Draft& d) { return &d.moments; })},
      {.path = "body.shape",
       .type = kWord,
       .words = shapeWords(),
       .example = "\"box\"",
       .help = "Uniform solid that sets the moments, together with size and mass. A cylinder's axis is z; a "
               "racket lies in the xy plane, its handle along -x.",
       .put = into([](Draft& d) { return &d.shape; })},
      {.path = "body.size",
       .type = kExtents,
       .dimension = kLength,
       .range = kExtent,
       .example = "[0.3, 0.2, 0.05]",
       .help = "Extents of the shape along the body's x, y and z axes; one number for all three.",
       .put = into([](Draft& d) { return &d.size_m; })},
      {.path = "body.mass",
       .dimension = kMass,
       .range = kMoments,
       .example = "\"320 g\"",
       .help = "Mass of the shape.",
       .put = into([](Draft& d) { return &d.mass_kg; })},

      {.path = "motion.omega_body",
       .type = kVector,
       .dimension = kAngularVelocity,
       .range = kSpins,
       .example = "[0.01, \"3 rpm\", 0]",
       .help = "Angular velocity at motion time 0, components along the body's principal axes.",
       .put = into([](Draft& d) { return &d.omega_B; }),
       .required = true},
      {.path = "motion.orientation",
       .type = kQuaternion,
       .range = kQuaternionNorm,
       .example = "[1, 0, 0, 0]",
       .help = "Quaternion w, x, y, z taking body axes to world axes at motion time 0, normalised on reading. "
               "Without it, L is turned onto the vertical, so that the invariable plane is level.",
       .put = into([](Draft& d) { return &d.scene.motion.orientation_WB; })},
      {.path = "motion.L_points",
       .type = kWord,
       .words = {"auto", "down", "up"},
       .fallback = "\"auto\"",
       .example = "\"up\"",
       .help = "Which way L points where no orientation is given; auto is down where the plane is shown, so that "
               "the ellipsoid rolls on it as on a table, and up elsewhere.",
       .put = into([](Draft& d) { return &d.scene.motion.lPoints; })},

      {.path = "time.start",
       .dimension = kTime,
       .range = kInstants,
       .fallback = "0",
       .example = "\"2 h\"",
       .help = "Motion time at the first frame.",
       .put = into([](Draft& d) { return &d.scene.time.start_s; })},
      {.path = "time.duration",
       .dimension = kTime,
       .range = {.least = 1e-3, .most = kLongestFilm_s},
       .fallback = "10",
       .example = "12.5",
       .help = "Length of the film; its frames are all k with k/fps below it, 36000 at most.",
       .put = into([](Draft& d) { return &d.scene.time.duration_s; })},
      {.path = "time.fps",
       .type = kFrameRate,
       .range = {.least = 1e-3, .most = kMostFps},
       .fallback = "30",
       .example = "\"30000/1001\"",
       .help = "Frames per second of film, kept as an exact fraction.",
       .put = into([](Draft& d) { return &d.scene.time.fps; })},
      {.path = "time.speed",
       .range = kInstants,
       .words = {"auto"},
       .fallback = "\"auto\"",
       .example = "0.5",
       .help = "Seconds of motion per second of film; negative runs backwards, auto chooses a pace that the eye "
               "follows.",
       .put = into([](Draft& d) { return &d.scene.time.speed; })},

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

      {.path = "show.title",
       .type = kText,
       .range = {.least = 0, .most = 200},
       .fallback = "\"\"",
       .example = "\"Tennis racket\"",
       .help = "A few words at the top left. Mathematics stands between dollar signs, in single quotes: 'About "
               "$\\hat{\\mathbf{e}}_2$'.",
       .put = into([](Draft& d) { return &d.scene.show.title; })},
      {.path = "show.subtitle",
       .type = kText,
       .range = {.least = 0, .most = 200},
       .fallback = "\"\"",
       .example = "'$I_1 < I_2 < I_3$'",
       .help = "One line under the title.",
       .put = into([](Draft& d) { return &d.scene.show.subtitle; })},
      {.path = "show.exaggerate_angles",
       .range = {.least = 1, .most = 1e9},
       .fallback = "1",
       .example = "100",
       .help = "Draws the part of omega across the main axis of spin that many times larger; the picture says so.",
       .put = into([](Draft& d) { return &d.scene.show.exaggerateAngles; })},
      {.path = "show.labels",
       .type = kBool,
       .fallback = "true",
       .example = "false",
       .help = "Names beside the vectors and axes.",
       .put = into([](Draft& d) { return &d.scene.show.labels; })},

      visibleKey("show.body.visible", "The body itself.",
                 into([](Draft& d) { return &d.scene.show.body.visible; })),
      scaleKey("show.body.scale", "Factor on its drawn size.",
               into([](Draft& d) { return &d.scene.show.body.scale; })),
      {.path = "show.body.shape",
       .type = kWord,
       .words = shapeWords(),
       .example = "\"racket\"",
       .help = "Shape to draw in place of the one that sets the moments (without either: the uniform box that has "
               "the moments).",
       .put = into([](Draft& d) { return &d.drawnShape; })},
      {.path = "show.body.size",
       .type = kExtents,
       .dimension = kLength,
       .range = kExtent,
       .example = "[3, 2, 1]",
       .help = "Extents of the shape to draw; only their proportions count. Without it: body.size where that is "
               "given, else proportions usual for the shape.",
       .put = into([](Draft& d) { return &d.drawnSize; })},

      visibleKey("show.principal_axes.visible", "The principal axes, fixed in the body.",
                 into([](Draft& d) { return &d.scene.show.principalAxes.visible; })),
      scaleKey("show.principal_axes.scale", "Factor on their length.",
               into([](Draft& d) { return &d.scene.show.principalAxes.scale; })),
      visibleKey("show.L.visible", "The angular momentum L, an arrow fixed in space.",
                 into([](Draft& d) { return &d.scene.show.L.visible; })),
      scaleKey("show.L.scale", "Factor on its length.", into([](Draft& d) { return &d.scene.show.L.scale; })),
      visibleKey("show.omega.visible", "The angular velocity omega, an arrow to the point of contact.",
                 into([](Draft& d) { return &d.scene.show.omega.visible; })),
      scaleKey("show.omega.scale", "Factor on its length; other than 1, its tip leaves the point of contact.",
               into([](Draft& d) { return &d.scene.show.omega.scale; })),

      visibleKey("show.ellipsoid.visible", "Poinsot's energy ellipsoid, in the space of omega.",
                 into([](Draft& d) { return &d.scene.show.ellipsoid.visible; })),
      scaleKey("show.ellipsoid.scale",
               "Factor on its drawn size and on all that touches it: plane, curves, point of contact.",
               into([](Draft& d) { return &d.scene.show.ellipsoid.scale; })),
      opacityKey("show.ellipsoid.opacity", "0.13", into([](Draft& d) { return &d.scene.show.ellipsoid.opacity; })),
      {.path = "show.ellipsoid.graticule",
       .type = kBool,
       .fallback = "true",
       .example = "false",
       .help = "Lines on the ellipsoid that make its rolling visible.",
       .put = into([](Draft& d) { return &d.scene.show.ellipsoid.graticule; })},

      visibleKey("show.plane.visible", "The invariable plane, on which the ellipsoid rolls.",
                 into([](Draft& d) { return &d.scene.show.plane.visible; })),
      opacityKey("show.plane.opacity", "0.16", into([](Draft& d) { return &d.scene.show.plane.opacity; })),
      {.path = "show.plane.grid",
       .type = kBool,
       .fallback = "true",
       .example = "false",
       .help = "Lines on the plane that give it scale.",
       .put = into([](Draft& d) { return &d.scene.show.plane.grid; })},

      visibleKey("show.contact.visible", "The point of contact: the tip of omega.",
                 into([](Draft& d) { return &d.scene.show.contact.visible; })),
      scaleKey("show.contact.scale", "Factor on its drawn size.",
               into([](Draft& d) { return &d.scene.show.contact.scale; })),
      visibleKey("show.polhode.visible", "The path of the point of contact on the ellipsoid.",
                 into([](Draft& d) { return &d.scene.show.polhode.visible; })),
      visibleKey("show.herpolhode.visible", "The path of the point of contact on the plane.",
                 into([](Draft& d) { return &d.scene.show.herpolhode.visible; })),
      {.path = "show.herpolhode.future",
       .type = kBool,
       .fallback = "true",
       .example = "false",
       .help = "Whether the part not yet travelled is drawn too, faint.",
       .put = into([](Draft& d) { return &d.scene.show.herpolhode.future; })},
      visibleKey("show.height.visible", "The constant height of the centre above the plane, 2T/|L|.",
                 into([](Draft& d) { return &d.scene.show.height.visible; })),

      {.path = "style.theme",
       .type = kWord,
       .words = {"light", "dark"},
       .fallback = "\"light\"",
       .example = "\"dark\"",
       .help = "White ground for print, dark for slides.",
       .put = into([](Draft& d) { return &d.scene.style.theme; })},
      {.path = "style.line_width",
       .range = kFactor,
       .fallback = "1",
       .example = "1.5",
       .help = "Factor on the width of all lines.",
       .put = into([](Draft& d) { return &d.scene.style.lineWidth; })},
      {.path = "style.text_size",
       .range = kFactor,
       .fallback = "1",
       .example = "1.25",
       .help = "Factor on the size of all type.",
       .put = into([](Draft& d) { return &d.scene.style.textSize; })},

      {.path = "output.quality",
       .type = kWord,
       .words = qualityWords(),
       .fallback = "\"1080p\"",
       .example = "\"preview\"",
       .help = "Sets size and crf together; either, given besides, wins.",
       .put = into([](Draft& d) { return &d.quality; })},
      {.path = "output.size",
       .type = kPixels,
       .range = {.least = kLeastSide, .most = kMostSide},
       .example = "[1280, 720]",
       .help = "Width and height of the picture in pixels, both even; 64 million pixels at most.",
       .put = into([](Draft& d) { return &d.size_px; })},
      {.path = "output.crf",
       .type = kInteger,
       .range = {.least = 0, .most = 51},
       .example = "20",
       .help = "Constant rate factor of the film: 0 is lossless, 18 shows no loss, 51 is worst.",
       .put = into([](Draft& d) { return &d.crf; })},
  };
}

}  // namespace

const std::vector<Key>& keys() {
  static const std::vector<Key> table = makeKeys();
  return table;
}

}  // namespace poinsot::scene
