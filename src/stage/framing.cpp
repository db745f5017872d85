// SPDX-License-Identifier: Apache-2.0
#include "stage/framing.h"

#include <algorithm>
#include <cmath>

#include "core/expect.h"
#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

// How far along one side of the picture the points reach: sides are x <= k (d + z) seen from the target, k the
// tangent of the side's angle; the camera at distance d shows what has x - k z at most k d.
double reach(const std::vector<Vector3d>& points_C, int axis, double sign, double k) {
  double farthest = -1e300;
  for (const Vector3d& p : points_C) farthest = std::max(farthest, sign * p[axis] + k * p.z());
  return farthest;
}

struct Fit {
  double distance, shift;
};

// The smallest distance at which both sides hold, and the sideways shift of the target it needs.
Fit fitBetween(const std::vector<Vector3d>& points_C, int axis, double kLow, double kHigh) {
  const double low = reach(points_C, axis, -1, kLow), high = reach(points_C, axis, 1, kHigh);
  const double distance = (low + high) / (kLow + kHigh);
  return {distance, high - kHigh * distance};
}

// The shift that leaves both sides equally free at a distance that is larger than needed.
double centredShift(const std::vector<Vector3d>& points_C, int axis, double kLow, double kHigh, double distance) {
  const double low = reach(points_C, axis, -1, kLow), high = reach(points_C, axis, 1, kHigh);
  const double lowest = high - kHigh * distance, highest = kLow * distance - low;
  return 0.5 * (lowest + highest);
}

}  // namespace

draw::Camera frameAll(const scene::Camera& camera, const std::vector<Vector3d>& points_V, const Margins& margins,
                      glm::vec2 size_px) {
  POINSOT_EXPECT(!points_V.empty());
  const double ca = std::cos(camera.azimuth_rad), sa = std::sin(camera.azimuth_rad);
  const double ce = std::cos(camera.elevation_rad), se = std::sin(camera.elevation_rad);
  const Vector3d backward(ca * ce, sa * ce, se), right(-sa, ca, 0), up = backward.cross(right);
  std::vector<Vector3d> points_C;
  for (const Vector3d& p : points_V) points_C.emplace_back(right.dot(p), up.dot(p), backward.dot(p));

  const double tanY = std::tan(0.5 * camera.fov_rad);
  const double tanX = tanY * static_cast<double>(size_px.x) / static_cast<double>(size_px.y);
  const double left = tanX * (1 - 2 * margins.left), toRight = tanX * (1 - 2 * margins.right);
  const double bottom = tanY * (1 - 2 * margins.bottom), top = tanY * (1 - 2 * margins.top);
  const double needed =
      std::max(fitBetween(points_C, 0, left, toRight).distance, fitBetween(points_C, 1, bottom, top).distance);
  const double shiftX = centredShift(points_C, 0, left, toRight, needed);
  const double shiftY = centredShift(points_C, 1, bottom, top, needed);
  const double distance = needed / camera.zoom;

  const Vector3d target = shiftX * right + shiftY * up;
  draw::Camera result = draw::lookAt(toPicture(Vector3d(target + distance * backward)), toPicture(target),
                                     glm::vec3(0, 0, 1), static_cast<float>(camera.fov_rad), size_px);
  double nearest = 1e300, farthest = -1e300;
  for (const Vector3d& p : points_C) {
    nearest = std::min(nearest, distance - p.z());
    farthest = std::max(farthest, distance - p.z());
  }
  const double slack = 0.3 * (farthest - nearest) + 0.1;
  result.near = static_cast<float>(std::max(nearest - slack, 0.02 * distance));
  result.far = static_cast<float>(farthest + slack);
  return result;
}

}  // namespace poinsot::stage
