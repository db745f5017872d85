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

/// Path of a view's camera over the film: the scene's camera, moved by its orbit and by the timeline.
class CameraPath {
 public:
  CameraPath(const scene::Camera& camera, const scene::Timeline& timeline, double duration_s);

  scene::Camera at(double filmTime_s) const;
  /// Returns true if the camera looks in one direction throughout the film. The zoom may still change.
  bool still() const;
  /// Returns the camera at 181 evenly spaced film times, or a single camera if the path is still().
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

/// Framing of a view for a camera path. The scale fits the complete motion from all directions of the path, so
/// that the drawing keeps its size while the camera moves. The latest results are cached, because each takes up to
/// a few milliseconds to compute and is needed again for the next picture. Thread-safe.
class PathFraming {
 public:
  explicit PathFraming(const CameraPath& path) : directions_(path.directions()), still_(path.still()) {}

  /// Returns the smallest fittingUnit_px() of all directions of the path.
  double unit_px(const Extent& extent, const Margins& margins, glm::vec2 size_px) const;
  /// Returns frameAll() for one camera of the path, at a scale that fits for all cameras of the path.
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
