// SPDX-License-Identifier: Apache-2.0
#include "stage/camera_path.h"

#include <algorithm>
#include <limits>

namespace poinsot::stage {
namespace {

// Number of steps along the path. In a full orbit, a step is 2 degrees. The reach of the drawing then changes by
// only 0.02 % within a step.
constexpr int kOrbitDirections = 180;

}  // namespace

CameraPath::CameraPath(const scene::Camera& camera, const scene::Timeline& timeline, double duration_s)
    : camera_(camera), duration_s_(duration_s), moves_(tracksOf(camera, timeline)) {}

CameraPath::Tracks CameraPath::tracksOf(const scene::Camera& camera, const scene::Timeline& timeline) {
  Tracks tracks{scene::EasedTrack(camera.azimuth_rad), scene::EasedTrack(camera.elevation_rad),
                scene::EasedTrack(camera.zoom)};
  for (const scene::TimelineEntry& entry : timeline.entries) {
    const auto move = [&](scene::EasedTrack& track, double target) {
      track.turnTo(entry.at_s, entry.over_s, target);
    };
    if (entry.azimuth_rad) move(tracks.azimuth_rad, *entry.azimuth_rad);
    if (entry.turn_rad != 0) move(tracks.azimuth_rad, tracks.azimuth_rad.target() + entry.turn_rad);
    if (entry.elevation_rad) move(tracks.elevation_rad, *entry.elevation_rad);
    if (entry.zoom) move(tracks.zoom, *entry.zoom);
  }
  return tracks;
}

scene::Camera CameraPath::at(double filmTime_s) const {
  scene::Camera camera = camera_;
  camera.azimuth_rad = moves_.azimuth_rad.at(filmTime_s) + camera_.orbit_rad * (filmTime_s / duration_s_);
  camera.elevation_rad = moves_.elevation_rad.at(filmTime_s);
  camera.zoom = moves_.zoom.at(filmTime_s);
  return camera;
}

bool CameraPath::still() const {
  return camera_.orbit_rad == 0 && moves_.azimuth_rad.constant() && moves_.elevation_rad.constant();
}

std::vector<scene::Camera> CameraPath::directions() const {
  if (still()) return {camera_};
  std::vector<scene::Camera> cameras;
  for (int i = 0; i <= kOrbitDirections; ++i) cameras.push_back(at(duration_s_ * i / kOrbitDirections));
  return cameras;
}

double PathFraming::unit_px(const Extent& extent, const Margins& margins, glm::vec2 size_px) const {
  const std::lock_guard lock(mutex_);
  if (unit_ && unit_->margins == margins && unit_->size_px == size_px) return unit_->unit_px;
  double least = std::numeric_limits<double>::infinity();
  for (const scene::Camera& camera : directions_)
    least = std::min(least, fittingUnit_px(camera, extent, margins, size_px));
  unit_ = Unit{margins, size_px, least};
  return least;
}

draw::Camera PathFraming::camera(const scene::Camera& placed, const Extent& extent, const Margins& margins,
                                 glm::vec2 size_px, double mostUnit_px) const {
  const double most_px = still_ ? mostUnit_px : std::min(mostUnit_px, unit_px(extent, margins, size_px));
  const Asked asked{placed.azimuth_rad, placed.elevation_rad, placed.zoom, margins, size_px, most_px};
  const std::lock_guard lock(mutex_);
  if (!last_ || !(last_->first == asked)) last_ = {asked, frameAll(placed, extent, margins, size_px, most_px)};
  return last_->second;
}

}  // namespace poinsot::stage
