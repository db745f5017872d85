// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/precession_cones.h"
#include "stage/figures/actor.h"

namespace poinsot::stage {

/// The body cone of a free symmetric top, about k, rolling on the space cone, about L (eq 30 to 37): omega is the
/// line in which they touch. Apexes at the origin, sides equally long.
class ConesFigure final : public Actor {
 public:
  /// @throws core::Error(kScene) where the motion has no such cones.
  explicit ConesFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

  /// One of the two at an instant: a unit vector and half the angle at the apex.
  struct Cone {
    Eigen::Vector3d axis_V;
    double halfAngle_rad;
  };
  Cone bodyCone(const PictureState& state) const;
  Cone spaceCone(const PictureState& state) const;
  /// Length of the sides in the picture.
  double side() const { return side_; }

 private:
  std::vector<Eigen::Vector3d> rim(const Cone& cone) const;
  void addCone(const Canvas& canvas, const Cone& cone, const Eigen::Vector3d& hint_V,
               const draw::Color& color) const;
  draw::GlassCone glass(const Canvas& canvas, const Cone& cone, const draw::Color& color) const;

  physics::PrecessionCones cones_;
  double side_;
  double opacity_;
};

}  // namespace poinsot::stage
