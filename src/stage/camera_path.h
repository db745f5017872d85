// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "scene/motion/eased_track.h"
#include "scene/scene.h"
#include "stage/framing.h"

namespace poinsot::stage {

/// Where a view's camera stands while the film runs: as its scene has it, moved by an orbit and by the timeline.
class CameraPath {
 public:
  CameraPath(const scene::Camera& camera, const scene::Timeline& timeline, double duration_s);

  scene::Camera at(double filmTime_s) const;
  /// It stands in one direction all the time.
  bool still() const;
  /// Directions that it looks from over the film, close to one another; where it is still, one.
  std::vector<scene::Camera> directions() const;

 private:
  struct Tracks {
    scene::EasedTrack azimuth_rad, elevation_rad, zoom;
  };
  static Tracks tracksOf(const scene::Camera& camera, const scene::Timeline& timeline);

  scene::Camera camera_;
  double duration_s_;
  Tracks moves_;
};

/// The camera on its path. The whole motion is drawn as large as it can be from all of the path's directions
/// alike, so that nothing breathes while the camera moves. The answers for what was asked last are kept: they cost
/// up to a few milliseconds, and every picture of a film asks for the same. Safe from several threads.
class PathFraming {
 public:
  explicit PathFraming(const CameraPath& path) : directions_(path.directions()), still_(path.still()) {}

  /// The least fittingUnit_px() of all directions.
  double unit_px(const Extent& extent, const Margins& margins, glm::vec2 size_px) const;
  /// frameAll() of a camera of the path.
  draw::Camera camera(const scene::Camera& placed, const Extent& extent, const Margins& margins, glm::vec2 size_px,
                      double mostUnit_px) const;

 private:
  struct Unit {
    Margins margins;
    glm::vec2 size_px;
    double unit_px;
  };
  struct Asked {
    double azimuth_rad, elevation_rad, zoom;
    Margins margins;
    glm::vec2 size_px;
    double mostUnit_px;
    bool operator==(const Asked&) const = default;
  };
  std::vector<scene::Camera> directions_;
  bool still_;
  mutable std::mutex mutex_;
  mutable std::optional<Unit> unit_;
  mutable std::optional<std::pair<Asked, draw::Camera>> last_;
};

}  // namespace poinsot::stage
