// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "physics/driven_state.h"
#include "physics/principal_moments.h"

namespace poinsot::physics {

/// The torque-free rotation over a short time, for the integrator that makes millions of such steps. Its error is
/// a few roundings of the angle turned, for any body and start. (FreeMotion is for any time, and sets up constants
/// that here would serve one step only.)
class FreeFlow {
 public:
  explicit FreeFlow(const PrincipalMoments& moments) : I_{moments[0], moments[1], moments[2]} {}

  /// Turns the attitude by the free rotation over h_s seconds (either sign); the angular momentum in space stays.
  /// More than 2500 rad make it not a number: a driven motion takes steps of a radian.
  void apply(DrivenState& state, double h_s) const;

 private:
  TurnLessOne turnOver(const std::array<double, 3>& m_P, double h_s) const;

  std::array<double, 3> I_;
};

/// |v|, for any v that does not overflow itself.
double norm(const std::array<double, 3>& v);

/// The turn about axes of the body that leaves the vector m fixed in space while its components in the body go
/// from the unit vector m0 to m0 + change: by the angle phi about m0, then the shortest way. @pre |change| < 1.
TurnLessOne turnKeeping(const std::array<double, 3>& m0, const std::array<double, 3>& change, double phi);

}  // namespace poinsot::physics
