// SPDX-License-Identifier: Apache-2.0
#include "physics/splitting.h"

#include <algorithm>
#include <cmath>

#include "core/expect.h"
#include "physics/transcendental.h"

namespace poinsot::physics {
namespace {

using Components = std::array<double, 3>;

Components componentsOf(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

Components torqueOf(const LeverTorque& lever, const Rotor<double>& q_WP) {
  const Components x = rotated(q_WP, lever.columns_P[0]), y = rotated(q_WP, lever.columns_P[1]),
                   z = rotated(q_WP, lever.columns_P[2]);
  return {z[1] - y[2], x[2] - z[0], y[0] - x[1]};
}

/// Times within a step, each rounded to a multiple of one ulp of h. The intervals between them therefore add up to
/// exactly h. Otherwise, all steps would be too long or too short by the same rounding error.
class StepGrid {
 public:
  explicit StepGrid(double h) : h_(h) {
    int exponent = 0;
    std::frexp(h, &exponent);
    unit_ = std::ldexp(1.0, std::max(exponent - 53, -1074));
  }
  double at(double part) const { return part == 1 ? h_ : std::round(part * h_ / unit_) * unit_; }

 private:
  double h_, unit_;
};

}  // namespace

Splitting::Splitting(const PrincipalAxes& axes, const Forcing& forcing)
    : free_(axes.moments()),
      I_(componentsOf(axes.moments().values())),
      gravity_P_(componentsOf(axes.toP(forcing.gravity_B))),
      heavy_(!forcing.gravity_B.isZero(0)),
      dragRate_(componentsOf(forcing.dragRate_P)),
      anisotropic_(dragRate_[0] != dragRate_[1] || dragRate_[1] != dragRate_[2]),
      alpha_(forcing.dissipation) {}

double Splitting::angularSpeed(const DrivenState& state) const {
  const Components m = state.momentum_P();
  return norm({m[0] / I_[0], m[1] / I_[1], m[2] / I_[2]});
}

double Splitting::fastestRate(const DrivenState& state) const {
  const auto [least, most] = std::minmax({I_[0], I_[1], I_[2]});
  const double L = norm(state.momentum_P());
  const double loss = alpha_ * L * L * (1 / least - 1 / most);
  return std::max({angularSpeed(state), loss, dragRate_[0], dragRate_[1], dragRate_[2]});
}

// |L| decays at least as fast as e^(-d t), where d is the smallest drag rate. The remaining turn is therefore at
// most |L|/(I_min d).
double Splitting::untilRest_s(const DrivenState& state, const ForcingPiece& piece) const {
  constexpr double kNoTurn_rad = 1e-290;
  const double slowest = std::min({dragRate_[0], dragRate_[1], dragRate_[2]});
  if (slowest == 0 || heavy_ || !piece.torque_P.zero() || !piece.torque_W.zero() || !piece.lever.zero() ||
      piece.end_s < piece.begin_s)
    return HUGE_VAL;
  const double left_rad = norm(state.momentum_P()) / std::min({I_[0], I_[1], I_[2]}) / slowest;
  return left_rad <= kNoTurn_rad ? 0 : (logarithm(left_rad) - logarithm(kNoTurn_rad)) / slowest;
}

void Splitting::step(DrivenState& state, const Composition& composition, const ForcingPiece& piece, double since,
                     double h) const {
  POINSOT_EXPECT(composition.ofSymmetricSteps || !dependsOnMomentum());
  const StepGrid grid(h);
  double drifted = 0, kicked = 0;
  for (std::size_t i = 0; i < composition.drifts.size(); ++i) {
    const double impulse = grid.at(composition.kicks[i]), end = grid.at(composition.drifts[i]);
    kick(state, piece, since + drifted, impulse - kicked);
    driftWithLosses(state, end - drifted);
    kicked = impulse;
    drifted = end;
  }
  kick(state, piece, since + h, h - kicked);
  state.normalize();
}

void Splitting::driftWithLosses(DrivenState& state, double h) const {
  const double half = 0.5 * h;
  drag(state, half);
  dissipate(state, half);
  drift(state, h);
  dissipate(state, half);
  drag(state, half);
}

void Splitting::kick(DrivenState& state, const ForcingPiece& piece, double since, double h) const {
  const Rotor<double> q_WP = toDouble(state.q_WP);
  if (heavy_) {
    const Components r_W = rotated(q_WP, gravity_P_);
    state.addMomentum(h, {-r_W[1], r_W[0], 0});
  }
  if (!piece.torque_P.zero()) state.addMomentum(h, rotated(q_WP, piece.torque_P.at(since)));
  if (!piece.torque_W.zero()) state.addMomentum(h, piece.torque_W.at(since));
  if (!piece.lever.zero()) state.addMomentum(h, torqueOf(piece.lever, q_WP));
}

// With equal drag rates d, the attitude is that of the free motion at the time tau = (1 - e^(-d t))/d, and L
// decays (decaying_motion.h).
void Splitting::drift(DrivenState& state, double h) const {
  const double d = anisotropic_ ? 0 : dragRate_[0];
  if (d == 0) return free_.apply(state, h);
  const double decay = exponentialLessOne(-d * h);
  free_.apply(state, -decay / d);
  state.addMomentum(decay, {state.L_W[0].hi, state.L_W[1].hi, state.L_W[2].hi});
}

void Splitting::drag(DrivenState& state, double h) const {
  if (!anisotropic_) return;
  const Components m = state.momentum_P();
  Components change;
  for (std::size_t i = 0; i < 3; ++i) change[i] = m[i] * exponentialLessOne(-dragRate_[i] * h);
  state.addMomentum(1, rotated(toDouble(state.q_WP), change));
}

// The components m_i are multiplied by e^(-alpha L^2 t/I_i), and m is scaled back to the length L. The attitude
// follows by the shortest turn. The error of the turn is of third order in h and odd, as a symmetric step needs.
void Splitting::dissipate(DrivenState& state, double h) const {
  if (alpha_ == 0) return;
  Components n = state.momentum_P();
  const double L = norm(n);
  if (L == 0) return;
  // Moment of the axis towards which m moves. With it, no exponential exceeds 1.
  const double gaining = h > 0 ? *std::max_element(I_.begin(), I_.end()) : *std::min_element(I_.begin(), I_.end());
  Components lost;
  double square = 0;  // squared new length, minus 1
  for (std::size_t i = 0; i < 3; ++i) {
    n[i] /= L;
    lost[i] = exponentialLessOne(-(alpha_ * L * L * h) * ((gaining - I_[i]) / (gaining * I_[i])));
    square += n[i] * n[i] * (lost[i] * (2 + lost[i]));
  }
  const double length = std::sqrt(1 + square);
  const double rescaling = -square / (length * (1 + length));
  for (std::size_t i = 0; i < 3; ++i) lost[i] = n[i] * (lost[i] + rescaling * (1 + lost[i]));
  state.turn(turnKeeping(n, lost, 0));
}

}  // namespace poinsot::physics
