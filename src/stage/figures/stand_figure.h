// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "draw/draw_list.h"
#include "stage/body/body_figure.h"
#include "stage/palette.h"
#include "stage/picture_motion.h"

namespace poinsot::stage {

/// Stand of a body that rotates about a point other than its centre of mass. The stand is a pedestal under the
/// pivot if the body always stays above the pedestal, otherwise a joint. A thin rod is added if the body does not
/// reach the pivot.
class StandFigure {
 public:
  /// @param scale  scale of the body, in picture lengths per metre
  StandFigure(const scene::Scene& scene, const PictureMotion& motion, const BodyFigure& body, double scale);

  void add(draw::DrawList& list, const PictureState& state, const Palette& colors) const;

  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const;

 private:
  void addRod(draw::DrawList& list, const PictureState& state, const Palette& colors) const;

  std::vector<Eigen::Vector3d> outer_B_;  // outermost points of the body, in picture lengths
  bool hasPedestal_ = false;
  double bodyRadius_;
  Eigen::Vector3d toCentre_B_;  // vector from the pivot to the centre of mass, in picture lengths; zero: no rod
};

/// Returns true if the body rotates about a point other than its centre of mass.
bool standsOnPivot(const scene::Scene& scene);

}  // namespace poinsot::stage
