// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/precession_cones.h"
#include "stage/figures/actor.h"

namespace poinsot::stage {

/// Look of a cone: lengths are fractions of its side, widths multiples of an ordinary line's.
struct ConeLook {
  /// Length of the sides relative to omega, whose head stays visible beyond the rims.
  static constexpr double kSide = 0.76;
  /// Part of a side without lines, because lines would crowd at the apex.
  static constexpr double kInside = 0.3;
  static constexpr double kRimWidth = 2.2;
  static constexpr double kLineShare = 0.6;  ///< strength of the colour of the lines along the sides
  static constexpr double kNameSize = 0.8;
};

/// Actor for the two cones of a free symmetric top (eq 30 to 37). The body cone, about k, rolls on the space cone,
/// about L. The cones touch along omega. Their apexes are at the origin and their sides are equally long.
class ConesFigure final : public Actor {
 public:
  /// @throws core::Error(kScene) unless the motion is that of a free symmetric top.
  explicit ConesFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

  struct Cone {
    Eigen::Vector3d axis_V;
    double halfAngle_rad;
  };
  Cone bodyCone(const PictureState& state) const;
  Cone spaceCone(const PictureState& state) const;
  /// Returns the length of the cones' sides, in picture lengths.
  double side() const { return side_; }

 private:
  std::vector<Eigen::Vector3d> rim(const Cone& cone) const;
  void addCone(const Canvas& canvas, const Cone& cone, const Eigen::Vector3d& hint_V,
               const draw::Color& color) const;
  void addName(const Canvas& canvas, const Cone& cone, const Cone& other, scene::LabelName name,
               const draw::Color& color) const;
  draw::GlassCone glass(const Canvas& canvas, const Cone& cone, const draw::Color& color) const;

  physics::PrecessionCones cones_;
  double side_;
  double opacity_;
};

}  // namespace poinsot::stage
