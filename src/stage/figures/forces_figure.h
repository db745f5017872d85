// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "stage/figures/actor.h"

namespace poinsot::stage {

/// Actor for the forces at points of the body (eq 8, 9). A force is an arrow at its point while the force acts.
/// Its length is relative to the largest of the forces. The arrow begins at the point. If it would lead into the
/// body, it ends at the point instead. With `arms`, an arrow r from the fixed point leads to the point.
class ForcesFigure final : public Actor {
 public:
  struct Arrow {
    Eigen::Vector3d from_V, tip_V;
    bool endsAtPoint;
  };

  explicit ForcesFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  /// Returns the ends of all arrows, also of those whose force does not act. A window may be shorter than the time
  /// between two states.
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

  std::size_t count() const { return forces_.size(); }
  bool acts(std::size_t i, const PictureState& state) const;
  /// Returns the arrow of a force, whether or not the force acts. @pre i < count().
  Arrow arrow(std::size_t i, const PictureState& state) const;

 private:
  struct Drawn {
    Eigen::Vector3d point_B, force_B, force_W;  // in picture lengths
    double from_s, to_s;
    bool endsAtPoint;
    std::string name, armName;
  };

  Eigen::Vector3d along_V(const Drawn& force, const PictureState& state) const;
  bool leadsInwards(const Setting& setting, const std::vector<PictureState>& states, const Drawn& force) const;

  void addArm(const Canvas& canvas, const Drawn& force, const PictureState& state) const;

  std::vector<Drawn> forces_;
  bool arms_;
  double extent_;
};

}  // namespace poinsot::stage
