// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "stage/figures/actor.h"
#include "stage/figures/construction.h"

/// Actors for the parts of Poinsot's construction. They draw nothing while the body is at rest.
/// @pre of each: the setting has a construction.
namespace poinsot::stage {

/// Actor for the energy ellipsoid, drawn as glass with a graticule.
class EllipsoidFigure final : public Actor {
 public:
  explicit EllipsoidFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

 private:
  const Construction& construction_;
  double opacity_;
  bool graticule_;
};

/// Actor for the invariable plane with its grid, its name, and the shadow of the ellipsoid that touches it.
class PlaneFigure final : public Actor {
 public:
  explicit PlaneFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

 private:
  void addName(const Canvas& canvas, const PictureState& state) const;

  const Construction& construction_;
  double opacity_;
  bool grid_, shadow_;
};

/// Actor for the point of contact, the tip of omega.
class ContactFigure final : public Actor {
 public:
  explicit ContactFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;
  Eigen::Vector3d growsFrom(const PictureState& state) const override { return scale_ * state.omega_V; }

 private:
  double scale_, radius_;
};

/// Actor for the height of the centre above the plane, 2T/L (eq 40): a dimension line beside the ellipsoid.
class HeightFigure final : public Actor {
 public:
  explicit HeightFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  /// Returns no points, because the position of the line depends on the camera.
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

 private:
  const Construction& construction_;
};

}  // namespace poinsot::stage
