// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/parts.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "physics/precession_cones.h"
#include "physics/transcendental.h"
#include "scene/assembly/steady_precession.h"
#include "scene/camera_preset.h"

namespace poinsot::scene {
namespace {

/// Sets the camera to a preset, except values that the scene gives by a key.
/// @param prefix  path of the table that contains "camera": "" for the scene, "view[1]." for a view
void usePreset(const std::optional<int>& preset, const std::string& prefix, const Findings& findings,
               Camera& camera) {
  if (!preset) return;
  constexpr double kDegree = std::numbers::pi / 180;
  const CameraPreset& chosen = cameraPresets()[static_cast<std::size_t>(*preset)];
  if (!findings.has(prefix + "camera.azimuth")) camera.azimuth_rad = chosen.azimuth_deg * kDegree;
  if (!findings.has(prefix + "camera.elevation")) camera.elevation_rad = chosen.elevation_deg * kDegree;
  if (chosen.projection && !findings.has(prefix + "camera.projection")) camera.projection = *chosen.projection;
}

/// Returns the angle from the x axis to the vector (x, y). Has the same bits on every CPU, unlike atan2.
double heading_rad(double x, double y) {
  const double fromBehind = std::sqrt(x * x + y * y) + x;
  return fromBehind > 0 ? 2 * physics::arcTangent(y / fromBehind) : std::numbers::pi;
}

/// Places the camera beside the path of a thrown body, so that the body flies to the right. A camera with a fixed
/// azimuth would see some throws along their direction.
void standBesideFlight(const Draft& draft, const Findings& findings, Scene& scene) {
  if (!scene.motion.flight || draft.preset || findings.has("camera.azimuth")) return;
  constexpr double kFromHeading = -70 * std::numbers::pi / 180;
  const Eigen::Vector3d& v = scene.motion.flight->velocity_W;
  if (v[0] != 0 || v[1] != 0) scene.camera.azimuth_rad = heading_rad(v[0], v[1]) + kFromHeading;
}

void checkFollow(const Camera& camera, const Show& show, const std::string& prefix, const Scene& scene,
                 Findings& findings) {
  const std::string follow = prefix + "camera.follow", zoom = prefix + "camera.zoom";
  if (camera.follow && !scene.motion.flight && findings.has(follow))
    findings.refuse(follow, "nothing is thrown: give [motion.flight], or leave it out");
  constexpr double kMost = 1.1;  // with a larger zoom, the flight extends beyond the margins of the picture
  if (movesAlong(scene.motion, camera, show) && !camera.follow && camera.zoom > kMost && findings.has(zoom))
    findings.doubt(zoom,
                   "the thrown body starts and ends outside the picture, because a zoom of 1 shows its whole "
                   "flight; set camera.follow = true to follow the body");
}

void checkFrame(const View& view, const std::string& path, const Scene& scene, const std::optional<Rest>& rest,
                Findings& findings) {
  const bool startKnown = rest || !scene.motion.omega_B.isZero(0);
  if (view.camera.frame != CameraFrame::kPrecession || !startKnown) return;
  if (const std::string why = withoutPrecession(scene, rest); !why.empty())
    findings.refuse(path, fmt::format("\"precession\" does not exist: {}", why));
}

const char* headingOf(CameraFrame frame) {
  switch (frame) {
    case CameraFrame::kSpace:
      return "In space";
    case CameraFrame::kBody:
      return "In the body";
    case CameraFrame::kPrecession:
      return "With the precession";
  }
  return "";
}

std::vector<View> viewsOf(const std::vector<CameraFrame>& frames, PanelGrid& grid, const Scene& scene) {
  std::vector<View> views;
  for (const CameraFrame frame : frames) {
    View& view = views.emplace_back();
    view.camera = scene.camera;
    view.show = scene.show;
    view.camera.frame = frame;
    view.place = grid.take(frames.size() > 1 ? "a view of camera.frames" : "the view", {}, {});
    if (frames.size() > 1) view.title = headingOf(frame);
  }
  return views;
}

void refuseFrames(Findings& findings) {
  if (!findings.has("camera.frames")) return;
  if (findings.count("view") > 0)
    findings.refuse("camera.frames",
                    "each [[view]] has a camera.frame of its own; give frames or views, not both");
  if (findings.has("camera.frame"))
    findings.refuse("camera.frame",
                    "cannot be combined with camera.frames; give frame for one panel, frames for several");
}

View viewOf(const ViewDraft& given, const std::string& prefix, const Findings& findings, const Scene& scene) {
  Draft whole;  // temporary draft that receives the keys of the view
  whole.scene.camera = scene.camera;
  whole.scene.show = scene.show;
  for (const auto& put : given.given) put(whole);
  View view{.camera = whole.scene.camera,
            .show = whole.scene.show,
            .title = given.title,
            .subtitle = given.subtitle,
            .place = {}};
  usePreset(whole.preset, prefix, findings, view.camera);
  return view;
}

/// Makes `count` views. The draft may contain fewer views, because it ends at the last view with a valid key.
std::vector<View> givenViews(const Draft& draft, std::size_t count, const std::optional<Rest>& rest,
                             Findings& findings, PanelGrid& grid, const Scene& scene) {
  std::vector<View> views;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string path = fmt::format("view[{}]", i);
    const ViewDraft given = i < draft.views.size() ? draft.views[i] : ViewDraft();
    View view = viewOf(given, path + ".", findings, scene);
    view.place = grid.take(path, given.at, given.span);
    assembleVisible(scene, rest, path + ".", findings, view.show);
    checkFollow(view.camera, view.show, path + ".", scene, findings);
    const bool own = findings.has(path + ".camera.frame");
    checkFrame(view, own ? path + ".camera.frame" : "camera.frame", scene, rest, findings);
    views.push_back(std::move(view));
  }
  return views;
}

/// Checks a scene with `show.views = false`, whose picture must consist of plots.
void refuseNoViews(Findings& findings) {
  if (findings.count("view") > 0)
    findings.refuse("show.views", "is false, but the scene has a [[view]]; leave out one of the two");
  if (findings.count("plot") == 0)
    findings.refuse("show.views", "without views and without a [[plot]] nothing is left to draw");
}

}  // namespace

void assembleViews(const Draft& draft, const std::optional<Rest>& rest, Findings& findings, PanelGrid& grid,
                   Scene& scene) {
  refuseFrames(findings);
  if (draft.noViews) refuseNoViews(findings);
  usePreset(draft.preset, "", findings, scene.camera);
  standBesideFlight(draft, findings, scene);
  const std::size_t count = findings.count("view");
  // With [[view]] tables, the scene's [show] only supplies defaults. Without views, [show] draws nothing.
  const bool start = count > 0 || draft.noViews;
  assembleVisible(scene, start ? std::nullopt : rest, "", findings, scene.show);
  scene.ownViews = count > 0;
  if (count > 0) scene.views = givenViews(draft, count, rest, findings, grid, scene);
  if (start) return;
  scene.views = viewsOf(draft.frames.value_or(std::vector{scene.camera.frame}), grid, scene);
  checkFollow(scene.camera, scene.show, "", scene, findings);
  for (const View& view : scene.views)
    checkFrame(view, draft.frames ? "camera.frames" : "camera.frame", scene, rest, findings);
}

}  // namespace poinsot::scene
