// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>
#include <optional>
#include <vector>

#include "scene/eased_track.h"
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

/// How large the whole motion can be drawn from all of a path's directions alike, so that nothing breathes while
/// the camera moves.
class PathFraming {
 public:
  explicit PathFraming(const CameraPath& path) : directions_(path.directions()) {}

  /// The least fittingUnit_px() of all directions. The answer for the frame asked for last is kept: it costs a few
  /// milliseconds, and every picture of a film asks for the same one. Safe from several threads.
  double unit_px(const Extent& extent, const Margins& margins, glm::vec2 size_px) const;

 private:
  struct Answer {
    Margins margins;
    glm::vec2 size_px;
    double unit_px;
  };
  std::vector<scene::Camera> directions_;
  mutable std::mutex mutex_;
  mutable std::optional<Answer> last_;
};

}  // namespace poinsot::stage
