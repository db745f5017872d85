// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "draw/draw_list.h"
#include "stage/body/body_figure.h"
#include "stage/palette.h"
#include "stage/picture_motion.h"

namespace poinsot::stage {

/// What holds a body that turns about a point other than its centre of mass: a pedestal under the pivot where
/// the body stays above it all the time, else a joint, and a thin rod where the body does not reach the pivot.
class StandFigure {
 public:
  /// `scale`: picture lengths per metre of the body.
  StandFigure(const scene::Scene& scene, const PictureMotion& motion, const BodyFigure& body, double scale);

  void add(draw::DrawList& list, const PictureState& state, const Palette& colors) const;

  /// Points that the frame must hold at that instant, in V: the body and the pedestal.
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const;

 private:
  void addRod(draw::DrawList& list, const PictureState& state, const Palette& colors) const;

  std::vector<Eigen::Vector3d> outer_B_;  // the body's, in the picture's lengths
  bool hasPedestal_ = false;
  double bodyRadius_;           // in the picture
  Eigen::Vector3d toCentre_B_;  // from the pivot to the centre of mass, in the picture's lengths; zero: no rod
};

/// Whether the body turns about another point than its centre of mass.
bool standsOnPivot(const scene::Scene& scene);

}  // namespace poinsot::stage
