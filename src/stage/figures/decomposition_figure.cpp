// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/decomposition_figure.h"

#include "stage/figures/symmetric_top.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

constexpr double kPartArrowRadius = 0.023;  // thicker than the arrows of L and the axis, which these arrows cover

}  // namespace

DecompositionFigure::DecompositionFigure(const Setting& setting)
    : scale_(setting.scales.omega * setting.scene.show.figures.decomposition.scale) {
  if (const auto& rolling = setting.motion.rolling())
    rolling_ = rolling->cone;
  else
    cones_ = precessionOf(setting.motion, "show.decomposition.visible");
}

physics::AngularVelocityParts DecompositionFigure::parts_V(const PictureState& state) const {
  if (rolling_)
    return {scale_ * rolling_->rate * state.R_VW.col(2),
            scale_ * rolling_->spin() * (state.R_VB * rolling_->axis_B)};
  return cones_.parts(scale_ * state.omega_V, scale_ * state.R_VP * cones_.k_P);
}

void DecompositionFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  const auto [precession, spin] = parts_V(state);
  const Vector3d whole = scale_ * state.omega_V;
  const draw::Color& color = canvas.colors.omegaParts;
  canvas.arrow(precession, kPartArrowRadius, color);
  canvas.arrow(spin, kPartArrowRadius, color);
  canvas.point("precession", precession);
  canvas.point("spin", spin);
  canvas.dashes(precession, whole, color, 1.2);
  canvas.dashes(spin, whole, color, 1.2);
  canvas.label(scene::LabelName::kOmegaP, 0.8 * precession, 0.8 * whole, color);
  canvas.label(scene::LabelName::kSpin, spin, precession, color);
}

std::vector<Vector3d> DecompositionFigure::outermostPoints(const PictureState& state) const {
  const auto [precession, spin] = parts_V(state);
  return {precession, spin, scale_ * state.omega_V};
}

}  // namespace poinsot::stage
