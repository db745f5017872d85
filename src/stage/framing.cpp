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

  /// How far it reaches towards one side of the picture. At distance d the camera shows x <= k (d - z) on a side
  /// whose angle has tangent k: what counts is x + k z, which is at most r sqrt(1 + k²) on a ball.
  double reach(int axis, double sign, double k) const {
    double farthest = ballRadius > 0 ? ballRadius * std::sqrt(1 + k * k) : -1e300;
    for (const Vector3d& p : points_C) farthest = std::max(farthest, sign * p[axis] + k * p.z());
    return farthest;
  }
};

/// One direction of the picture: its low side (left, bottom) and its high one.
struct Sides {
  int axis;
  double kLow, kHigh;

  /// The smallest distance at which both hold, the target shifted as it pleases.
  double distance(const Seen& seen) const {
    return (seen.reach(axis, -1, kLow) + seen.reach(axis, 1, kHigh)) / (kLow + kHigh);
  }
  /// The shift of the target that leaves both equally free.
  double shift(const Seen& seen, double d) const {
    return 0.5 * (seen.reach(axis, 1, kHigh) - kHigh * d + kLow * d - seen.reach(axis, -1, kLow));
  }
};

}  // namespace

draw::Camera frameAll(const scene::Camera& camera, const Extent& extent, const Margins& margins,
                      glm::vec2 size_px) {
  POINSOT_EXPECT(!extent.points_V.empty() || extent.ballRadius > 0);
  const double ca = std::cos(camera.azimuth_rad), sa = std::sin(camera.azimuth_rad);
  const double ce = std::cos(camera.elevation_rad), se = std::sin(camera.elevation_rad);
  const Vector3d backward(ca * ce, sa * ce, se), right(-sa, ca, 0), up = backward.cross(right);
  Seen seen{{}, extent.ballRadius};
  for (const Vector3d& p : extent.points_V) seen.points_C.emplace_back(right.dot(p), up.dot(p), backward.dot(p));

  const double tanY = std::tan(0.5 * camera.fov_rad);
  const double tanX = tanY * static_cast<double>(size_px.x) / static_cast<double>(size_px.y);
  const Sides across{0, tanX * (1 - 2 * margins.left), tanX * (1 - 2 * margins.right)};
  const Sides upright{1, tanY * (1 - 2 * margins.bottom), tanY * (1 - 2 * margins.top)};
  const double needed = std::max(across.distance(seen), upright.distance(seen));
  const double shiftX = across.shift(seen, needed), shiftY = upright.shift(seen, needed);
  const double distance = needed / camera.zoom;

  const Vector3d target = shiftX * right + shiftY * up;
  draw::Camera result = draw::lookAt(toPicture(Vector3d(target + distance * backward)), toPicture(target),
                                     glm::vec3(0, 0, 1), static_cast<float>(camera.fov_rad), size_px);
  double nearest = distance - seen.ballRadius, farthest = distance + seen.ballRadius;
  for (const Vector3d& p : seen.points_C) {
    nearest = std::min(nearest, distance - p.z());
    farthest = std::max(farthest, distance - p.z());
  }
  const double slack = 0.3 * (farthest - nearest) + 0.1;
  result.near = static_cast<float>(std::max(nearest - slack, 0.02 * distance));
  result.far = static_cast<float>(farthest + slack);
  return result;
}

}  // namespace poinsot::stage
