// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "scene/keys/draft.h"
#include "scene/keys/findings.h"

namespace poinsot::scene {

/// Body that is given by its moments or its inertia tensor. Reads the keys that complete the body: mass, centre of
/// mass, pivot, and the point to which the moments refer.
class MeasuredBody {
 public:
  /// @param way  path of the key that gives the moments: "body.inertia" or "body.principal_moments"
  MeasuredBody(const Draft& draft, std::string way, Findings& findings);

  bool keysFit();

  /// Returns the mass, the centre of mass, and the inertia tensor about the centre of mass (eq 14). Returns
  /// nullopt if the mass is not given or the tensor is rejected.
  /// @param inertia_B  inertia tensor about the point to which the given moments refer, kg·m²
  std::optional<physics::MassProperties> massProperties(const Eigen::Matrix3d& inertia_B);

  /// Returns whether the moments refer to the point about which the body turns. Always true without a mass.
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

/// Rejects keys that only a body given by moments or a tensor may have.
/// @param way  key that describes the body instead, such as "body.shape"
void refuseMeasuredKeys(const std::string& way, Findings& findings);

}  // namespace poinsot::scene
