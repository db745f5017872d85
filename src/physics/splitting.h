// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "physics/composition.h"
#include "physics/driven_state.h"
#include "physics/forcing_piece.h"
#include "physics/free_flow.h"
#include "physics/principal_axes.h"

namespace poinsot::physics {

/// Motion of a driven body, split into flows that can each be solved exactly:
///
///   drift        free rotation, with drag if all rates are equal; the only flow in which time advances
///   kick         L += h N(R, t), at fixed attitude and time
///   drag         m_i -> e^(-d_i h) m_i, at fixed attitude
///   dissipation  m' = alpha m × (m × omega); the attitude follows, so that L is constant
///
/// Together, the flows approximate R' = R [omega + alpha m × omega], L' = N - R d R^-1 L (m = R^-1 L = I omega).
class Splitting {
 public:
  /// @pre forcing is valid.
  Splitting(const PrincipalAxes& axes, const Forcing& forcing);

  /// Advances the state by one step of h_s seconds (either sign). The step begins at the time piece.begin_s +
  /// since_s.
  /// @pre the composition is one of symmetric steps if dependsOnMomentum().
  void step(DrivenState& state, const Composition& composition, const ForcingPiece& piece, double since_s,
            double h_s) const;

  double angularSpeed(const DrivenState& state) const;
  /// Returns the largest of |omega|, the drag rates and the rate of dissipation, 1/s. Steps must not be much
  /// longer than the inverse of this rate. Otherwise stages that run backwards in time, and undo drag and
  /// dissipation, would blow up.
  double fastestRate(const DrivenState& state) const;

  /// Returns the time until drag brings the body to rest, s. A body counts as at rest if it will turn by at most
  /// another 1e-290 rad. The time is 0 if the body is at rest now, and infinite if other torques act or if time
  /// runs backwards.
  double untilRest_s(const DrivenState& state, const ForcingPiece& piece) const;

  /// Returns whether drag or dissipation depends on the angular momentum. Only compositions of symmetric steps
  /// then keep their order.
  bool dependsOnMomentum() const { return anisotropic_ || alpha_ > 0; }

 private:
  void kick(DrivenState& state, const ForcingPiece& piece, double since_s, double h_s) const;
  void driftWithLosses(DrivenState& state, double h_s) const;
  void drift(DrivenState& state, double h_s) const;
  void drag(DrivenState& state, double h_s) const;
  void dissipate(DrivenState& state, double h_s) const;

  FreeFlow free_;
  std::array<double, 3> I_;
  std::array<double, 3> gravity_P_;
  bool heavy_;
  std::array<double, 3> dragRate_;
  bool anisotropic_;
  double alpha_;
};

}  // namespace poinsot::physics
