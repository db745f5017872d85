// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/ghosts_figure.h"

#include "stage/framing.h"
#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

constexpr double kGhostsApart = 0.006;  // distance between poses along the view, in picture lengths

using Eigen::Vector3d;

std::vector<double> timesOf(const Setting& setting) {
  const auto& ghosts = setting.scene.show.figures.ghosts;
  if (!ghosts.times_s.empty()) return ghosts.times_s;
  std::vector<double> times_s;
  for (int i = 0; i < ghosts.count; ++i) times_s.push_back(setting.scene.time.duration_s * i / ghosts.count);
  return times_s;
}

Palette pale(const Palette& colors, double strength) {
  Palette all = colors;
  for (draw::Color* color : {&all.body, &all.bodyEdge, &all.rod}) *color = mixed(*color, colors.paper, strength);
  return all;
}

}  // namespace

GhostsFigure::GhostsFigure(const Setting& setting)
    : body_(setting.body),
      scale_(setting.scales.body),
      strength_(setting.scene.show.figures.ghosts.strength),
      moves_(setting.motion.flight()),
      flightScale_(setting.scales.flight) {
  const Vector3d step_V = 2 * scale_ * body_.halfExtents().maxCoeff() *
                          (cameraAxes_V(setting.scene.camera) * setting.scene.show.figures.ghosts.step);
  for (const double time_s : timesOf(setting)) {
    const PictureState state = setting.motion.at(time_s);
    const auto places = static_cast<double>(poses_.size() + 1);
    const Vector3d place_V = moves_ ? Vector3d(setting.scales.flight * state.centre_V) : Vector3d(places * step_V);
    poses_.push_back({time_s, state.R_VW.transpose() * state.R_VB, place_V});
  }
}

Vector3d GhostsFigure::place_V(const Pose& pose, const PictureState& state) const {
  return moves_ ? Vector3d(pose.place_V - flightScale_ * state.centre_V) : pose.place_V;
}

// If the body moves through the view, only past poses are drawn, as in a stroboscopic photograph. Older poses are
// moved a little away from the eye, because faces in the same plane would show through each other.
void GhostsFigure::add(const Canvas& canvas, double filmTime_s, const PictureState& state) const {
  const Palette colors = pale(canvas.colors, strength_);
  const Vector3d away_V = -kGhostsApart * fromPicture(canvas.list.camera.R_VC[2]);
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    if (moves_ && poses_[i].filmTime_s > filmTime_s) continue;
    Vector3d place = place_V(poses_[i], state);
    if (moves_) place += static_cast<double>(poses_.size() - i) * away_V;
    body_.add(canvas.list, {state.R_VW * poses_[i].R_WB, scale_, place}, colors, canvas.line_px);
  }
}

std::vector<Vector3d> GhostsFigure::outermostPoints(const PictureState& state) const {
  std::vector<Vector3d> points;
  for (const Pose& pose : poses_)
    for (const Vector3d& point_V : body_.outermostPoints({state.R_VW * pose.R_WB, scale_, place_V(pose, state)}))
      points.push_back(point_V);
  return points;
}

}  // namespace poinsot::stage
