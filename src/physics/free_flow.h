// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "physics/driven_state.h"
#include "physics/principal_moments.h"

namespace poinsot::physics {

/// Torque-free rotation over a short time, for the integrator, which makes millions of such steps. Its error is a
/// few roundings of the angle turned, for any body and start. (FreeMotion is for any time; its constants would
/// have to be computed anew for each step.)
class FreeFlow {
 public:
  explicit FreeFlow(const PrincipalMoments& moments) : I_{moments[0], moments[1], moments[2]} {}

  /// Turns the attitude by the free rotation over h_s seconds (either sign). The angular momentum in space is
  /// unchanged. A turn of more than 2500 rad gives NaN; a driven motion takes steps of a radian.
  void apply(DrivenState& state, double h_s) const;

 private:
  TurnLessOne turnOver(const std::array<double, 3>& m_P, double h_s) const;

  std::array<double, 3> I_;
};

/// Returns |v| for any v whose length is in the range of doubles.
double norm(const std::array<double, 3>& v);

/// Returns the turn, about axes of the body, that keeps the vector m fixed in space while its components in the
/// body go from the unit vector m0 to m0 + change: first by the angle phi about m0, then the shortest way.
/// @pre |change| < 1.
TurnLessOne turnKeeping(const std::array<double, 3>& m0, const std::array<double, 3>& change, double phi);

}  // namespace poinsot::physics
