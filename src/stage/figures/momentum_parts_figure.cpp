// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/momentum_parts_figure.h"

#include "stage/figures/symmetric_top.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

// Radii of the arrow along omega: it covers a longer arrow of omega, and a shorter arrow of omega covers it, so
// that both tips are seen.
constexpr double kThickPart = 0.023, kThinPart = 0.015;
constexpr double kPaleL = 0.75;
constexpr double kLeastPart = 0.06;  // a shorter part has no room for its label

}  // namespace

MomentumPartsFigure::MomentumPartsFigure(const Setting& setting)
    : cones_(precessionOf(setting.motion, "show.L_parts.visible")),
      omegaScale_(setting.scene.show.omega.visible ? setting.scales.omega : 0) {
  const physics::PrincipalMoments& I = setting.motion.moments();
  const double scale = setting.scales.L * setting.scene.show.figures.LParts.scale;
  const int beside = (cones_.axis + 1) % 3;
  across_ = scale * I[beside];
  difference_ = cones_.sense == physics::RollingSense::kNone ? 0 : scale * (I[cones_.axis] - I[beside]);
}

MomentumPartsFigure::Parts MomentumPartsFigure::parts_V(const PictureState& state) const {
  return {across_ * state.omega_V, difference_ * state.omega_P.dot(cones_.k_P) * state.R_VP * cones_.k_P};
}

// The names are outside the triangle of both parts and L.
void MomentumPartsFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  const auto [alongOmega, alongAxis] = parts_V(state);
  const draw::Color color = mixed(canvas.colors.L, canvas.colors.paper, kPaleL);
  const auto name = [&](scene::LabelName label, const Vector3d& at, const Vector3d& along, const Vector3d& third) {
    const Vector3d inwards = third - at, unit = along.normalized();
    canvas.label(label, at, at + inwards - inwards.dot(unit) * unit, canvas.colors.L, 0.85);
  };
  const bool covers = alongOmega.norm() < omegaScale_ * state.omega_V.norm();
  canvas.arrow(alongOmega, covers ? kThickPart : kThinPart, color);
  canvas.point("L-omega", alongOmega);
  name(scene::LabelName::kLAlongOmega, 0.7 * alongOmega, alongOmega, alongOmega + alongAxis);
  if (!(alongAxis.norm() > 0)) return;
  canvas.arrowFrom(alongOmega, alongOmega + alongAxis, kThinPart, color);
  if (alongAxis.norm() > kLeastPart)
    name(scene::LabelName::kLAlongAxis, alongOmega + 0.5 * alongAxis, alongAxis, Vector3d::Zero());
}

std::vector<Vector3d> MomentumPartsFigure::outermostPoints(const PictureState& state) const {
  const auto [alongOmega, alongAxis] = parts_V(state);
  return {alongOmega, alongOmega + alongAxis};
}

}  // namespace poinsot::stage
