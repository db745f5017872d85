// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/plane_of_L_figure.h"

#include <algorithm>
#include <cmath>

#include "stage/figures/symmetric_top.h"
#include "stage/figures/triad_figure.h"
#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

constexpr double kSheetReach = 1.06;  // size of the sheet relative to the arrows in it
constexpr double kBehind = 0.12;      // length of the sheet behind the origin, as a fraction of its length ahead
constexpr double kParallel = 1e-6;    // rad; at smaller angles, rounding errors decide the direction of the plane

}  // namespace

PlaneOfLFigure::PlaneOfLFigure(const Setting& setting)
    : opacity_(setting.scene.show.figures.planeOfL.opacity), along_(0), across_(0) {
  const Vector3d k_P = mainAxis_P(setting.motion);
  const double i = setting.scene.show.figures.triad.visible ? triadLength(setting) : 0;
  const double k = std::max(i, setting.axisLengths.dot(k_P.cwiseAbs()));
  for (const PathPoint& p : setting.motion.outline()) {
    const PictureState state = setting.motion.atPlayed(p.played_s);
    if (state.L_V.isZero(0)) continue;
    const Vector3d l = state.L_V.normalized(), omega = setting.scales.omega * state.omega_V;
    const double cosine = l.dot(state.R_VP * k_P), sine = l.cross(state.R_VP * k_P).norm();
    along_ = std::max({along_, setting.scales.L * state.L_V.norm(), omega.dot(l), k * cosine, i * sine});
    across_ = std::max({across_, omega.cross(l).norm(), k * sine, i * std::abs(cosine)});
  }
  const double size = kSheetReach * setting.scene.show.figures.planeOfL.scale;
  along_ *= size;
  across_ *= size;
}

std::vector<Vector3d> PlaneOfLFigure::corners_V(const PictureState& state) const {
  if (state.L_V.isZero(0)) return {};
  const Vector3d l = state.L_V.normalized(), beside = state.omega_V - state.omega_V.dot(l) * l;
  if (!(beside.norm() > kParallel * state.omega_V.norm())) return {};
  const Vector3d u = across_ * beside.normalized(), top = along_ * l, foot = -kBehind * top;
  return {foot - u, foot + u, top + u, top - u};
}

void PlaneOfLFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  const std::vector<Vector3d> corners = corners_V(state);
  if (corners.empty()) return;
  draw::GlassPolygon& sheet = canvas.list.glassPolygons.emplace_back();
  for (const Vector3d& corner : corners) sheet.corners_V.push_back(toPicture(corner));
  sheet.color = canvas.colors.plane;
  sheet.opacity = canvas.glass(opacity_);
  sheet.lineColor = canvas.colors.planeLine;
  sheet.lineOpacity = 0.6f;
  sheet.lineWidth_px = static_cast<float>(0.8 * canvas.line_px);
}

std::vector<Vector3d> PlaneOfLFigure::outermostPoints(const PictureState& state) const { return corners_V(state); }

}  // namespace poinsot::stage
