// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "stage/figures/actor.h"
#include "stage/figures/construction.h"

/// The paths of the tip of omega. Where something acts on the body, they stay as they were travelled.
/// @pre of each: the setting has a construction.
namespace poinsot::stage {

/// On the body: the closed curve, what was travelled of it in the last period and, faint, the rest. Where
/// something acts, the curve is the one that the motion would follow from now on if nothing did, and all that was
/// travelled is shown.
class PolhodeFigure final : public Actor {
 public:
  explicit PolhodeFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

 private:
  struct Sample {
    double played_s;
    Eigen::Vector3d omega_P;  // rad/s
  };

  /// Of a closed curve, what was not travelled from `from_s` to now; of another all.
  std::vector<Eigen::Vector3d> untravelled(double now_s, double from_s) const;
  void addUntravelled(const Canvas& canvas, const PictureState& state, double now_s, double from_s) const;
  void addTube(const Canvas& canvas, const PictureState& state, const std::vector<Eigen::Vector3d>& omega_P,
               bool closed, double radius, const draw::Color& color) const;

  const PictureMotion& motion_;
  double scale_;
  bool onEllipsoid_;          // which is drawn
  std::vector<Sample> free_;  // of free motion: the curve, over one period
  double period_s_;           // of played time; infinite where the curve does not close
};

/// On the plane: what was travelled, its last second strong; what is to come, faint. In a film of very many turns,
/// the nearest ones.
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
