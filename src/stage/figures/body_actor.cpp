// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/body_actor.h"

namespace poinsot::stage {

BodyActor::BodyActor(const Setting& setting)
    : body_(setting.body), scale_(setting.scales.body), movesAlong_(setting.motion.flight()) {
  if (standsOnPivot(setting.scene)) stand_.emplace(setting.scene, setting.motion, body_, scale_);
}

void BodyActor::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  body_.add(canvas.list, {state.R_VB, scale_}, canvas.colors, canvas.line_px);
  if (stand_) stand_->add(canvas.list, state, canvas.colors);
}

// A body that rotates about its centre of mass stays inside the ball of ballRadius(). For a body on a pivot or in
// flight, the points of each pose are returned instead, because it sweeps less space than a ball.
std::vector<Eigen::Vector3d> BodyActor::outermostPoints(const PictureState& state) const {
  if (stand_) return stand_->outermostPoints(state);
  return movesAlong_ ? body_.outermostPoints({state.R_VB, scale_}) : std::vector<Eigen::Vector3d>();
}

double BodyActor::ballRadius() const { return stand_ || movesAlong_ ? 0 : scale_ * body_.radius(); }

}  // namespace poinsot::stage
