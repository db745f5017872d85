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
  /// `way`: the key that gives the moments, "body.inertia" or "body.principal_moments".
  MeasuredBody(const Draft& draft, std::string way, Findings& findings);

  /// Whether these keys fit together; what does not is refused.
  bool keysFit();

  /// The mass, its centre and the tensor about its centre (eq 14). Empty without a mass, and if the tensor is
  /// refused.
  /// @param inertia_B  about the point that the keys name, kg·m²
  std::optional<physics::MassProperties> massProperties(const Eigen::Matrix3d& inertia_B);

  /// Whether the moments are about the point that the body turns about. So they are without a mass.
  bool aboutFixedPoint() const { return point_B() == fixedPoint_B(); }

 private:
  bool massFits();
  bool pointFits();
  Eigen::Vector3d fixedPoint_B() const { return pivot_B_.value_or(centre_B_); }
  /// The point that the moments are about.
  Eigen::Vector3d point_B() const;
  std::string contradiction(const std::string& why) const;

  const BodyDraft& draft_;
  const std::optional<Eigen::Vector3d>& pivot_B_;
  Eigen::Vector3d centre_B_;
  std::string way_;
  Findings& findings_;
};

/// Refuses the keys that only a body of measured moments has, beside another way to describe a body.
void refuseMeasuredKeys(const std::string& way, Findings& findings);

}  // namespace poinsot::scene
