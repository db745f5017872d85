// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "physics/composition.h"
#include "physics/driven_state.h"
#include "physics/forcing_piece.h"
#include "physics/free_flow.h"
#include "physics/principal_axes.h"

namespace poinsot::physics {

/// The motion of a driven body taken apart into flows that are each exactly solvable:
///
///   drift        the free rotation, with drag where its rates are equal; time runs in it alone
///   kick         L += h N(R, t), the attitude and the time fixed
///   drag         m_i -> e^(-d_i h) m_i, the attitude fixed
///   dissipation  m' = alpha m × (m × omega), the attitude following so that L stays
///
/// The flow of the whole is R' = R [omega + alpha m × omega], L' = N - R d R^-1 L (m = R^-1 L = I omega).
class Splitting {
 public:
  /// @pre forcing is valid.
  Splitting(const PrincipalAxes& axes, const Forcing& forcing);

  /// One step of h_s seconds (either sign) from the time `since_s` after the piece's begin. @pre the composition
  /// is one of symmetric steps where dependsOnMomentum().
  void step(DrivenState& state, const Composition& composition, const ForcingPiece& piece, double since_s,
            double h_s) const;

  /// |omega|, rad/s.
  double angularSpeed(const DrivenState& state) const;
  /// The fastest of |omega|, the drag and the dissipation, 1/s: stages that run backwards undo the latter two, and
  /// would blow up in steps much longer than their time.
  double fastestRate(const DrivenState& state) const;

  /// The time after which the body is at rest, s: drag is all that acts, and no turn above 1e-290 rad is left. Not
  /// positive: it is at rest now. Infinite where something else acts, or time runs backwards.
  double untilRest_s(const DrivenState& state, const ForcingPiece& piece) const;

  /// Whether the kicks are joined by flows that depend on the angular momentum, so that only compositions of
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
