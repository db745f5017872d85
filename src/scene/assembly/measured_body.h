// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "scene/keys/draft.h"
#include "scene/keys/findings.h"

namespace poinsot::scene {

/// Keys that complete a body given by its moments or its tensor: mass, centre of mass, pivot, and the point that
/// the moments are about.
class MeasuredBody {
 public:
  /// @param way  key that gives the moments, "body.inertia" or "body.principal_moments"
  MeasuredBody(const Draft& draft, std::string way, Findings& findings);

  bool keysFit();

  /// Returns the mass, the centre of mass and the tensor about it (eq 14). Empty without a mass, or if the tensor
  /// is rejected.
  /// @param inertia_B  about the point that the keys name, kg·m²
  std::optional<physics::MassProperties> massProperties(const Eigen::Matrix3d& inertia_B);

  /// Returns whether the moments are about the point that the body turns about. Always true without a mass.
  bool aboutFixedPoint() const { return point_B() == fixedPoint_B(); }

 private:
  bool massFits();
  bool pointFits();
  Eigen::Vector3d fixedPoint_B() const { return pivot_B_.value_or(centre_B_); }
  Eigen::Vector3d point_B() const;
  std::string contradiction(const std::string& why) const;

  const BodyDraft& draft_;
  const std::optional<Eigen::Vector3d>& pivot_B_;
  Eigen::Vector3d centre_B_;
  std::string way_;
  Findings& findings_;
};

/// Rejects keys of measured moments in a body that is described in another way.
void refuseMeasuredKeys(const std::string& way, Findings& findings);

}  // namespace poinsot::scene
