// SPDX-License-Identifier: Apache-2.0
#include "stage/ghosts_figure.h"

#include "stage/framing.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

std::vector<double> timesOf(const Setting& setting) {
  const auto& ghosts = setting.scene.show.figures.ghosts;
  if (!ghosts.times_s.empty()) return ghosts.times_s;
  std::vector<double> times_s;
  for (int i = 0; i < ghosts.count; ++i) times_s.push_back(setting.scene.time.duration_s * i / ghosts.count);
  return times_s;
}

/// The colours of a pale body.
Palette pale(const Palette& colors, double strength) {
  Palette all = colors;
  for (draw::Color* color : {&all.body, &all.bodyEdge, &all.rod}) *color = mixed(*color, colors.paper, strength);
  return all;
}

}  // namespace

GhostsFigure::GhostsFigure(const Setting& setting)
    : body_(setting.body), scale_(setting.scales.body), strength_(setting.scene.show.figures.ghosts.strength) {
  const Vector3d step_V = 2 * scale_ * body_.halfExtents().maxCoeff() *
                          (cameraAxes_V(setting.scene.camera) * setting.scene.show.figures.ghosts.step);
  for (const double time_s : timesOf(setting)) {
    const PictureState state = setting.motion.at(time_s);
    const auto places = static_cast<double>(poses_.size() + 1);
    poses_.push_back({state.R_VW.transpose() * state.R_VB, places * step_V});
  }
}

void GhostsFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  const Palette colors = pale(canvas.colors, strength_);
  for (const Pose& pose : poses_)
    body_.add(canvas.list, {state.R_VW * pose.R_WB, scale_, pose.place_V}, colors, canvas.line_px);
}

std::vector<Vector3d> GhostsFigure::outermostPoints(const PictureState& state) const {
  std::vector<Vector3d> points;
  for (const Pose& pose : poses_)
    for (const Vector3d& direction_B : cubeDirections())
      points.push_back(pose.place_V + scale_ * (state.R_VW * pose.R_WB * body_.supportPoint(direction_B)));
  return points;
}

}  // namespace poinsot::stage
