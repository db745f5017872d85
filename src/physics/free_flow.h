// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "physics/driven_state.h"
#include "physics/principal_moments.h"

namespace poinsot::physics {

/// Torque-free rotation over a short time, for an integrator that makes millions of steps. For any body and start,
/// the error is a few roundings of the turned angle. (FreeMotion can reach any time, but would have to compute its
/// constants anew for each step.)
class FreeFlow {
 public:
  explicit FreeFlow(const PrincipalMoments& moments) : I_{moments[0], moments[1], moments[2]} {}

  /// Rotates the attitude as a free body rotates in h_s seconds (either sign). The angular momentum in space does
  /// not change. A turn of more than 2500 rad gives NaN. (Steps of a driven motion turn by about 1 rad.)
  void apply(DrivenState& state, double h_s) const;

 private:
  TurnLessOne turnOver(const std::array<double, 3>& m_P, double h_s) const;

  std::array<double, 3> I_;
};

/// Returns the length of a vector. No square overflows or underflows.
double norm(const std::array<double, 3>& v);

/// Returns a turn, about axes of the body, that keeps the vector m fixed in space. In the body, m changes from the
/// unit vector m0 to m0 + change. The turn is a rotation by the angle phi about m0, followed by the shortest turn.
/// @pre |change| < 1.
TurnLessOne turnKeeping(const std::array<double, 3>& m0, const std::array<double, 3>& change, double phi);

}  // namespace poinsot::physics
