// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "physics/polhode_regime.h"
#include "stage/figures/actor.h"

namespace poinsot::stage {

/// Closed curve fixed in the body, in picture lengths.
struct BodyCurve {
  std::vector<Eigen::Vector3d> points_P;
  bool separatrix = false;
};

/// Actor for several polhodes of the body on its energy ellipsoid. They have the same energy and different L, and
/// are evenly spaced from the axes to the separatrix. The separatrix is drawn strong.
class PolhodesFigure final : public Actor {
 public:
  /// @throws core::Error(kScene) unless the motion is free.
  explicit PolhodesFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

  const std::vector<BodyCurve>& curves() const { return curves_; }

 private:
  std::vector<BodyCurve> curves_;
};

/// Actor for Binet's construction. In the body, the tip of L lies on the momentum sphere |m| = L and on the energy
/// ellipsoid with semi-axes sqrt(2 T I), and moves along their intersection. Also shows the separatrix and other
/// polhodes of the sphere. On request, fills the part of the sphere that the polhode encloses.
class BinetFigure final : public Actor {
 public:
  /// @throws core::Error(kScene) unless the motion is free, or if no area exists that the scene shows; kPhysics
  /// for a body at rest.
  explicit BinetFigure(const Setting& setting);

  void add(const Canvas& canvas, double filmTime_s, const PictureState& state) const override;
  std::vector<Eigen::Vector3d> outermostPoints(const PictureState& state) const override;

  /// Returns the sphere's radius in picture lengths.
  double sphereRadius() const { return radius_; }
  const Eigen::Vector3d& semiAxes_P() const { return semiAxes_P_; }
  const std::vector<BodyCurve>& curves() const { return curves_; }
  const std::vector<Eigen::Vector3d>& polhode_P() const { return polhode_P_; }
  /// Returns the filled part of the sphere as a thin shell along the principal axes, in picture lengths; null if
  /// the scene does not show it.
  const std::shared_ptr<const draw::TriangleMesh>& area_P() const { return area_P_; }

 private:
  void fillArea(const physics::PrincipalMoments& moments, physics::PolhodeRegime regime);

  double opacity_;
  double radius_;
  Eigen::Vector3d semiAxes_P_;
  std::vector<BodyCurve> curves_;
  std::vector<Eigen::Vector3d> polhode_P_;
  std::shared_ptr<const draw::TriangleMesh> area_P_;
  bool closes_;   // false on the separatrix, where the curve is not closed
  double scale_;  // picture lengths per kg·m²/s
};

}  // namespace poinsot::stage
