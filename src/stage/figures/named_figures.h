// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "stage/figures/actor.h"

namespace poinsot::stage {

/// Directions in one picture, looked up by their names in a scene.
class Directions {
 public:
  explicit Directions(const Setting& setting);

  /// Returns the unit vector of a direction, or zero if the direction does not exist, such as L of a body at rest.
  Eigen::Vector3d operator()(scene::Direction direction, const PictureState& state) const;
  /// Returns the approximate length with which a direction is drawn.
  double length(scene::Direction direction) const;

 private:
  Eigen::Vector3d axis_P_, axisLengths_;
  double reach_, L_, omega_;
};

/// Actor for an arrow that the scene adds.
class NamedVectorFigure final : public Actor {
 public:
  NamedVectorFigure(const Setting& setting, const scene::NamedVector& vector);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

  struct Arrow {
    Eigen::Vector3d from_V, tip_V;
    /// Point where the two parts of a body point's velocity, V and omega × r, meet (eq 4). Set only while the body
    /// moves through the view.
    std::optional<Eigen::Vector3d> corner_V = {};
    double inBody_V = 0;  ///< extent of the body in which the arrow may be hidden; it is then dashed
  };
  Arrow arrow(const PictureState& state) const { return arrow_(state); }

 private:
  scene::NamedVector vector_;
  std::string pointName_;
  std::function<Arrow(const PictureState&)> arrow_;
};

/// Actor for an angle: the arc between two directions, with a label.
class AngleFigure final : public Actor {
 public:
  /// @param framed  true if the arc must be inside the picture
  AngleFigure(const Setting& setting, const scene::NamedAngle& angle, bool framed = true);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

  /// Returns the arc from one direction to the other, along a great circle. Returns no points if a direction does
  /// not exist or the directions are parallel.
  std::vector<Eigen::Vector3d> arc(const PictureState& state) const;

 private:
  Directions directions_;
  scene::NamedAngle angle_;
  double radius_;
  bool framed_;
};

/// Actor for the angle theta (show.theta). Without gravity, theta is the angle between L and k (lecture, eq 18).
/// Under gravity, theta is the angle between the vertical and k, and the vertical is drawn too.
class ThetaFigure final : public Actor {
 public:
  explicit ThetaFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;
  std::vector<Eigen::Vector3d> arc(const PictureState& state) const { return angle_.arc(state); }

 private:
  bool fromVertical_;
  AngleFigure angle_;
};

}  // namespace poinsot::stage
