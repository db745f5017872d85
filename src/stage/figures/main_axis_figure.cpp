// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/main_axis_figure.h"

#include "stage/figures/principal_axes_figure.h"
#include "stage/figures/symmetric_top.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

constexpr double kBeyondBase = 1.4;

Vector3d tip(const Setting& setting) {
  const Vector3d k_P = mainAxis_P(setting.motion);
  if (const auto& rolling = setting.motion.rolling())  // the axis ends beyond the base
    return kBeyondBase * setting.scene.show.figures.mainAxis.scale * setting.scales.body * rolling->cone.height_m *
           k_P;
  return setting.scene.show.figures.mainAxis.scale * setting.axisLengths.dot(k_P.cwiseAbs()) * k_P;
}

}  // namespace

MainAxisFigure::MainAxisFigure(const Setting& setting) : tip_P_(tip(setting)) {}

void MainAxisFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  const Vector3d tip_V = state.R_VP * tip_P_;
  canvas.arrow(tip_V, kAxisRadius, canvas.colors.axis);
  canvas.point("k", tip_V);
  canvas.label(scene::LabelName::kAxis, tip_V, Vector3d::Zero(), canvas.colors.axis);
}

std::vector<Vector3d> MainAxisFigure::outermostPoints(const PictureState& state) const {
  return {state.R_VP * tip_P_};
}

}  // namespace poinsot::stage
