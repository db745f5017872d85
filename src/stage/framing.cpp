// SPDX-License-Identifier: Apache-2.0
#include "stage/framing.h"

#include <algorithm>
#include <cmath>

#include "core/expect.h"
#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

/// An extent in camera axes about the centre: x right, y up, z towards the eye.
struct Seen {
  std::vector<Vector3d> points_C;
  double ballRadius;
  bool parallel;  // rays

  /// How far it reaches towards one side of the picture. At distance d the camera shows x <= k (d - z) on a side
  /// whose angle has tangent k: what counts is x + k z, which is at most r sqrt(1 + k²) on a ball. With parallel
  /// rays it shows x <= k d: what counts is x.
  double reach(int axis, double sign, double tangent) const {
    const double k = parallel ? 0 : tangent;
    double farthest = ballRadius > 0 ? ballRadius * std::sqrt(1 + k * k) : -1e300;
    for (const Vector3d& p : points_C) farthest = std::max(farthest, sign * p[axis] + k * p.z());
    return farthest;
  }
};

/// One direction of the picture: its low side (left, bottom) and its high one.
struct Sides {
  int axis;
  double kLow, kHigh;

  /// The smallest distance at which both hold, the target shifted as it pleases. With parallel rays: from which a
  /// pinhole would show what is across the view as large.
  double distance(const Seen& seen) const {
    return (seen.reach(axis, -1, kLow) + seen.reach(axis, 1, kHigh)) / (kLow + kHigh);
  }
  /// The shift of the target that leaves both equally free.
  double shift(const Seen& seen, double d) const {
    return 0.5 * (seen.reach(axis, 1, kHigh) - kHigh * d + kLow * d - seen.reach(axis, -1, kLow));
  }
};

/// An extent before a camera that stands in a direction and looks at it, at any distance.
struct Fit {
  double tanY;
  Vector3d right, up, backward;
  Seen seen;
  Sides across, upright;

  Fit(const scene::Camera& camera, const Extent& extent, const Margins& margins, glm::vec2 size_px)
      : tanY(std::tan(0.5 * camera.fov_rad)) {
    POINSOT_EXPECT(!extent.points_V.empty() || extent.ballRadius > 0);
    const double ca = std::cos(camera.azimuth_rad), sa = std::sin(camera.azimuth_rad);
    const double ce = std::cos(camera.elevation_rad), se = std::sin(camera.elevation_rad);
    backward = Vector3d(ca * ce, sa * ce, se);
    right = Vector3d(-sa, ca, 0);
    up = backward.cross(right);
    seen.ballRadius = extent.ballRadius;
    seen.parallel = camera.projection == scene::Projection::kOrthographic;
    for (const Vector3d& p : extent.points_V) seen.points_C.emplace_back(right.dot(p), up.dot(p), backward.dot(p));
    const double tanX = tanY * static_cast<double>(size_px.x) / static_cast<double>(size_px.y);
    across = Sides{0, tanX * (1 - 2 * margins.left), tanX * (1 - 2 * margins.right)};
    upright = Sides{1, tanY * (1 - 2 * margins.bottom), tanY * (1 - 2 * margins.top)};
  }

  double needed() const { return std::max(across.distance(seen), upright.distance(seen)); }
  /// The z axis; straight from above or below it has no direction in the picture.
  glm::vec3 upwards() const { return std::abs(backward.z()) > 0.9999 ? toPicture(up) : glm::vec3(0, 0, 1); }
};

/// Along the view, from the target plane: towards the eye and away from it.
struct Depths {
  double towards, away;

  explicit Depths(const Seen& seen) : towards(seen.ballRadius), away(seen.ballRadius) {
    for (const Vector3d& p : seen.points_C) {
      towards = std::max(towards, p.z());
      away = std::max(away, -p.z());
    }
  }
};

double focal_px(const Fit& fit, glm::vec2 size_px) { return 0.5 * static_cast<double>(size_px.y) / fit.tanY; }

}  // namespace

double fittingUnit_px(const scene::Camera& camera, const Extent& extent, const Margins& margins,
                      glm::vec2 size_px) {
  const Fit fit(camera, extent, margins, size_px);
  return focal_px(fit, size_px) / fit.needed();
}

draw::Camera frameAll(const scene::Camera& camera, const Extent& extent, const Margins& margins, glm::vec2 size_px,
                      double mostUnit_px) {
  const Fit fit(camera, extent, margins, size_px);
  const Seen& seen = fit.seen;
  const double needed = std::max(fit.needed(), focal_px(fit, size_px) / mostUnit_px);
  const double shiftX = fit.across.shift(seen, needed), shiftY = fit.upright.shift(seen, needed);
  const double distance = needed / camera.zoom;

  const Vector3d target = shiftX * fit.right + shiftY * fit.up;
  const Depths depths(seen);
  const double slack = 0.3 * (depths.towards + depths.away) + 0.1;
  // With parallel rays the eye may stand anywhere: here far enough for all to be before it.
  const double eye = seen.parallel ? std::max(distance, depths.towards + 2 * slack) : distance;
  draw::Camera result = draw::lookAt(toPicture(Vector3d(target + eye * fit.backward)), toPicture(target),
                                     fit.upwards(), static_cast<float>(camera.fov_rad), size_px);
  result.orthographic = seen.parallel;
  result.halfHeight_W = static_cast<float>(distance * fit.tanY);
  result.near = static_cast<float>(std::max(eye - depths.towards - slack, 0.02 * distance));
  result.far = static_cast<float>(eye + depths.away + slack);
  return result;
}

}  // namespace poinsot::stage
