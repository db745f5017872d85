// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "stage/figures/actor.h"
#include "stage/figures/construction.h"

/// Actors for the paths of the tip of omega. If something acts on the body, the travelled part of a path does not
/// change later.
/// @pre of each: the setting has a construction.
namespace poinsot::stage {

/// Actor for the polhode, a closed curve that is fixed in the body. The part travelled in the last period is
/// strong, and the rest is faint. If something acts on the body, everything travelled is strong, and the faint
/// curve is the one that a free motion would follow from now on.
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

  /// Returns the part of a closed curve that was not travelled from `from_s` to now. If the curve is not closed,
  /// returns the complete curve.
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
/// come is faint. If a film has very many turns, only the turns nearest to the present time are drawn.
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
