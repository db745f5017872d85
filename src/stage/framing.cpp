// SPDX-License-Identifier: Apache-2.0
#include "stage/framing.h"

#include <algorithm>
#include <cmath>

#include "core/expect.h"
#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

/// Extent in camera axes about the centre: x right, y up, z towards the eye.
struct Seen {
  std::vector<Vector3d> points_C;
  double ballRadius;
  bool parallel;  // orthographic camera

  /// Returns how far the extent reaches up (sign 1) or down (sign -1): the largest y + k z. Here k is the tangent
  /// of the angle of view on that side, because a camera at distance d sees the points with y <= k (d - z). On a
  /// ball of radius r, the largest y + k z is r sqrt(1 + k²). For an orthographic camera, which sees y <= k d, the
  /// reach is the largest y.
  double reach(double sign, double tangent) const {
    const double k = parallel ? 0 : tangent;
    double farthest = ballRadius > 0 ? ballRadius * std::sqrt(1 + k * k) : -1e300;
    for (const Vector3d& p : points_C) farthest = std::max(farthest, sign * p.y() + k * p.z());
    return farthest;
  }
};

/// Largest distances of the extent from the plane through the centre: towards the eye, and away from the eye.
struct Depths {
  double towards, away;

  explicit Depths(const Seen& seen) : towards(seen.ballRadius), away(seen.ballRadius) {
    for (const Vector3d& p : seen.points_C) include(p.z());
  }
  void include(double nearer) {
    towards = std::max(towards, nearer);
    away = std::max(away, -nearer);
  }
  double slack() const { return 0.3 * (towards + away) + 0.1; }
};

// Vertical fit: the eye and its target move up or down together.

/// Vertical field of view without margins: tangents of its angles below and above the middle of the picture.
struct Upright {
  double kLow, kHigh;

  /// Returns the smallest distance of the eye at which the extent fits vertically, if the target is shifted up or
  /// down in the best way. For an orthographic camera, returns the distance that gives a pinhole camera the same
  /// scale.
  double distance(const Seen& seen) const {
    return (seen.reach(-1, kLow) + seen.reach(1, kHigh)) / (kLow + kHigh);
  }
  /// Returns the shift of the target that leaves equal room below and above the extent.
  double shift(const Seen& seen, double d) const {
    return 0.5 * (seen.reach(1, kHigh) - kHigh * d + kLow * d - seen.reach(-1, kLow));
  }
};

// Horizontal fit: the eye stays in the vertical plane through the centre, so that L is upright in every picture.
// Instead, the image is shifted sideways, like the film of a view camera.

/// Apparent width of an extent: tangents of the angles from the vertical plane through the centre to the left and
/// right ends of the extent. `slope` is the derivative of their sum with respect to the eye's distance. For an
/// orthographic camera, the tangents are those of a pinhole camera with the same scale.
struct Width {
  double left = -1e300, right = -1e300, slope = 0;

  /// @pre the eye is farther away than the extent, or rays are parallel.
  Width(const Seen& seen, double d) {
    double leftSlope = 0, rightSlope = 0;
    const double r = seen.ballRadius;
    if (r > 0) {
      const double beyond = d * d - (seen.parallel ? 0 : r * r);
      left = right = r / std::sqrt(beyond);
      leftSlope = rightSlope = -d * left / beyond;
    }
    for (const Vector3d& p : seen.points_C) {
      const double away = seen.parallel ? d : d - p.z(), tangent = p.x() / away;
      if (tangent > right) right = tangent, rightSlope = -tangent / away;
      if (-tangent > left) left = -tangent, leftSlope = tangent / away;
    }
    slope = leftSlope + rightSlope;
  }

  double sum() const { return left + right; }
  /// Returns the tangent halfway between the two ends, positive to the right.
  double middle() const { return 0.5 * (right - left); }
};

/// Returns the smallest distance of the eye from which Width::sum() of the extent is at most `tangents`. Newton's
/// method converges, because the width is a convex function of the distance.
double distanceAcross(const Seen& seen, double tangents) {
  constexpr int kSteps = 40;
  const Depths depths(seen);
  const double size = std::max(depths.towards + depths.away, 1e-9);
  const double least = (seen.parallel ? 0 : depths.towards) + 1e-4 * size;
  double d = std::max(least, depths.towards + size);
  for (int i = 0; i < kSteps; ++i) {
    const Width width(seen, d);
    if (!(width.slope < 0)) break;
    const double next = std::max(d - (width.sum() - tangents) / width.slope, least);
    if (std::abs(next - d) < 1e-12 * d) break;
    d = next;
  }
  return d;
}

struct Fit {
  double tanY;
  Vector3d right, up, backward;
  Seen seen;
  Upright upright;
  double across;  // width of the picture without margins, in the units of Width::sum()
  double freeMiddle_px;

  Fit(const scene::Camera& camera, const Extent& extent, const Margins& margins, glm::vec2 size_px)
      : tanY(std::tan(0.5 * camera.fov_rad)) {
    POINSOT_EXPECT(!extent.points_V.empty() || extent.ballRadius > 0);
    const Eigen::Matrix3d axes_V = cameraAxes_V(camera);
    right = axes_V.col(0);
    up = axes_V.col(1);
    backward = axes_V.col(2);
    seen.ballRadius = extent.ballRadius;
    seen.parallel = camera.projection == scene::Projection::kOrthographic;
    for (const Vector3d& p : extent.points_V) seen.points_C.emplace_back(right.dot(p), up.dot(p), backward.dot(p));
    const double tanX = tanY * static_cast<double>(size_px.x) / static_cast<double>(size_px.y);
    across = 2 * tanX * (1 - margins.left - margins.right);
    freeMiddle_px = 0.5 * static_cast<double>(size_px.x) * (1 + margins.left - margins.right);
    upright = Upright{tanY * (1 - 2 * margins.bottom), tanY * (1 - 2 * margins.top)};
  }

  double needed() const { return std::max(distanceAcross(seen, across), upright.distance(seen)); }
  /// Returns the up direction of the camera: the z axis, unless the camera looks along the z axis.
  glm::vec3 upwards() const { return std::abs(backward.z()) > 0.9999 ? toPicture(up) : glm::vec3(0, 0, 1); }
};

double focal_px(const Fit& fit, glm::vec2 size_px) { return 0.5 * static_cast<double>(size_px.y) / fit.tanY; }

}  // namespace

Eigen::Matrix3d cameraAxes_V(const scene::Camera& camera) {
  const double ca = std::cos(camera.azimuth_rad), sa = std::sin(camera.azimuth_rad);
  const double ce = std::cos(camera.elevation_rad), se = std::sin(camera.elevation_rad);
  const Vector3d right(-sa, ca, 0), nearer(ca * ce, sa * ce, se);
  return (Eigen::Matrix3d() << right, nearer.cross(right), nearer).finished();
}

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
  const Vector3d target = fit.upright.shift(seen, needed) * fit.up;
  Depths depths(seen);
  for (const Vector3d& p : extent.passing_V) depths.include(fit.backward.dot(p));
  const double slack = depths.slack();
  // An orthographic camera may be at any distance. Here it is so far away that everything lies in front of it.
  const double eye = seen.parallel ? std::max(needed, depths.towards + 2 * slack) : needed;
  draw::Camera result = draw::lookAt(toPicture(Vector3d(target + eye * fit.backward)), toPicture(target),
                                     fit.upwards(), static_cast<float>(camera.fov_rad), size_px);
  // The zoom narrows the field of view. Moving the eye nearer instead could place it inside the drawing.
  result.tanHalfFovY = static_cast<float>(fit.tanY / camera.zoom);
  result.orthographic = seen.parallel;
  result.halfHeight_V = static_cast<float>(needed * fit.tanY / camera.zoom);
  const double aside_px = focal_px(fit, size_px) * Width(seen, needed).middle() * camera.zoom;
  result.centre_px.x = static_cast<float>(fit.freeMiddle_px - aside_px);
  result.centre_px += glm::vec2(camera.shift.x(), -camera.shift.y()) * size_px;
  result.near = static_cast<float>(std::max(eye - depths.towards - slack, 0.02 * needed));
  result.far = static_cast<float>(eye + depths.away + slack);
  return result;
}

bool cutsOff(const draw::Camera& camera, const Extent& extent) {
  constexpr float kRounding_px = 1;
  const auto isOutside = [&](const glm::vec2& at_px, float reach_px) {
    const glm::vec2 low = at_px - reach_px, high = at_px + reach_px - camera.size_px;
    return std::min(low.x, low.y) < -kRounding_px || std::max(high.x, high.y) > kRounding_px;
  };
  const glm::vec3 origin_V(0);
  const float ball_px = static_cast<float>(extent.ballRadius) * camera.scale_px(depthOf(camera, origin_V));
  if (extent.ballRadius > 0 && isOutside(draw::project(camera, origin_V), ball_px)) return true;
  return std::ranges::any_of(extent.points_V,
                             [&](const Vector3d& p) { return isOutside(draw::project(camera, toPicture(p)), 0); });
}

}  // namespace poinsot::stage
