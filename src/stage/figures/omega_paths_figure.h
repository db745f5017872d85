// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "stage/figures/actor.h"
#include "stage/figures/construction.h"

/// Actors for the paths of omega's tip. If something acts on the body, travelled paths stay as they were.
/// @pre of each: the setting has a construction.
namespace poinsot::stage {

/// Actor for the polhode on the body: a closed curve, strong where travelled in the last period and faint
/// elsewhere. If something acts on the body, the faint curve is the one that a free motion would follow from now
/// on, and everything travelled is shown.
class PolhodeFigure final : public Actor {
 public:
  explicit PolhodeFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

 private:
  struct Sample {
    double played_s;
    Eigen::Vector3d omega_P;
  };

  /// Returns the part of a closed curve that was not travelled from `from_s` to now. Returns all of a curve that
  /// is not closed.
  std::vector<Eigen::Vector3d> untravelled(double now_s, double from_s) const;
  void addUntravelled(const Canvas& canvas, const PictureState& state, double now_s, double from_s) const;
  void addTube(const Canvas& canvas, const PictureState& state, const std::vector<Eigen::Vector3d>& omega_P,
               bool closed, double radius, const draw::Color& color) const;

  const PictureMotion& motion_;
  double scale_;
  bool onEllipsoid_;
  std::vector<Sample> free_;  // curve of a free motion over one period
  double period_s_;           // period in played time; infinite if the curve does not close
};

/// Actor for the herpolhode on the plane. The travelled part is strong, its last 0.9 s strongest, and the part to
/// come is faint. In a film of very many turns, only the nearest turns are drawn.
class HerpolhodeFigure final : public Actor {
 public:
  explicit HerpolhodeFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

 private:
  void addPath(const Canvas& canvas, const PictureState& state, double from_s, double to_s,
               const draw::Color& color, double width, double lift) const;

  const PictureMotion& motion_;
  double scale_;
  bool future_;
};

}  // namespace poinsot::stage
