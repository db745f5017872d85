// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "stage/figures/actor.h"
#include "stage/figures/stand_figure.h"

namespace poinsot::stage {

/// Actor for the body, and for its stand if the body rotates about a pivot.
class BodyActor final : public Actor {
 public:
  explicit BodyActor(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;
  double ballRadius() const override;

 private:
  const BodyFigure& body_;
  double scale_;
  bool movesAlong_;
  std::optional<StandFigure> stand_;
};

}  // namespace poinsot::stage
