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
///   drift        the free rotation, with drag if its rates are equal; the only flow in which time runs
///   kick         L += h N(R, t), at fixed attitude and time
///   drag         m_i -> e^(-d_i h) m_i, at fixed attitude
///   dissipation  m' = alpha m × (m × omega), the attitude following so that L is constant
///
/// The flow of the whole is R' = R [omega + alpha m × omega], L' = N - R d R^-1 L (m = R^-1 L = I omega).
class Splitting {
 public:
  /// @pre forcing is valid.
  Splitting(const PrincipalAxes& axes, const Forcing& forcing);

  /// Advances the state by one step of h_s seconds (either sign), from the time `since_s` after the piece's begin.
  /// @pre the composition is one of symmetric steps if dependsOnMomentum().
  void step(DrivenState& state, const Composition& composition, const ForcingPiece& piece, double since_s,
            double h_s) const;

  double angularSpeed(const DrivenState& state) const;
  /// Returns the fastest of |omega|, the drag and the dissipation, 1/s. Stages that run backwards undo drag and
  /// dissipation, and would blow up in steps much longer than the inverse of their rates.
  double fastestRate(const DrivenState& state) const;

  /// Returns the time until the body is at rest, s: only drag acts, and at most a turn of 1e-290 rad is left. 0 if
  /// the body is at rest now, infinite if anything else acts or time runs backwards.
  double untilRest_s(const DrivenState& state, const ForcingPiece& piece) const;

  /// Returns whether the step has flows that depend on the angular momentum, so that only compositions of
  /// symmetric steps keep their order.
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
