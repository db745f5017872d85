// SPDX-License-Identifier: Apache-2.0
#include "physics/driven_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"
#include "core/expect.h"
#include "physics/decaying_motion.h"
#include "physics/step_choice.h"
#include "physics/transcendental.h"

namespace poinsot::physics {
namespace {

bool hasClosedForm(const Forcing& f) {
  Forcing other = f;
  other.dragRate_P.setZero();
  return other.none() && f.dragRate_P[0] == f.dragRate_P[1] && f.dragRate_P[1] == f.dragRate_P[2];
}

void requireSpan(const TimeSpan& span, double tolerance) {
  if (!std::isfinite(span.from_s) || !std::isfinite(span.to_s))
    throw core::physicsError(
        fmt::format("the span of a driven motion must be finite, got {} s to {} s", span.from_s, span.to_s));
  if (!(tolerance > 0 && std::isfinite(tolerance)))
    throw core::physicsError(fmt::format("the tolerance must be positive and finite, got {} rad", tolerance));
}

Rotor<DoubleDouble> exact(const Quaternion& q) { return {q.w(), q.x(), q.y(), q.z()}; }

/// Converts a start to the integrator's state, accurate to 100 bits.
DrivenState startOf(const PrincipalAxes& axes, const Eigen::Vector3d& omega0_B, const Quaternion& q0_WB) {
  DrivenState state;
  // Scales the quaternion by a power of two, so that no square overflows.
  int exponent = 0;
  std::frexp(q0_WB.coeffs().cwiseAbs().maxCoeff(), &exponent);
  Rotor<DoubleDouble> q =
      exact(Quaternion(q0_WB.coeffs().unaryExpr([&](double v) { return std::ldexp(v, -exponent); })));
  if (!axes.aligned()) q = q * normalized(exact(axes.q_BP()));
  state.q_WP = normalized(q);
  const Eigen::Vector3d omega_P = axes.toP(omega0_B);
  std::array<DoubleDouble, 3> m;
  for (int i = 0; i < 3; ++i) m[static_cast<std::size_t>(i)] = twoProduct(axes.moments()[i], omega_P[i]);
  state.L_W = rotated(state.q_WP, m);
  return state;
}

Quaternion attitude_B(const PrincipalAxes& axes, Rotor<double> q) {
  if (!axes.aligned()) {
    const Quaternion& q_BP = axes.q_BP();
    q = q * Rotor<double>{q_BP.w(), -q_BP.x(), -q_BP.y(), -q_BP.z()};
  }
  q = normalized(q);
  if (q.w < 0) q = {-q.w, -q.x, -q.y, -q.z};
  return {q.w, q.x, q.y, q.z};
}

RigidBodyState bodyState(const PrincipalAxes& axes, const DrivenState& driven, double t_s) {
  const std::array<double, 3> m = driven.momentum_P();
  const Eigen::Vector3d& I = axes.moments().values();
  const std::array<double, 3> omega_P = {m[0] / I[0], m[1] / I[1], m[2] / I[2]};
  const std::array<double, 3> omega_W = rotated(toDouble(driven.q_WP), omega_P);
  RigidBodyState state;
  state.t_s = t_s;
  state.q_WB = attitude_B(axes, toDouble(driven.q_WP));
  state.omega_B = axes.toB({omega_P[0], omega_P[1], omega_P[2]});
  state.omega_W = {omega_W[0], omega_W[1], omega_W[2]};
  state.L_W = {driven.L_W[0].hi, driven.L_W[1].hi, driven.L_W[2].hi};
  state.kineticEnergy = 0.5 * (omega_P[0] * m[0] + omega_P[1] * m[1] + omega_P[2] * m[2]);
  return state;
}

}  // namespace

struct DrivenMotion::Solution {
  Solution(const PrincipalAxes& axes_, const Forcing& forcing_) : axes(axes_), forcing(forcing_) {}

  void solveInClosedForm(const Eigen::Vector3d& omega0_B, const Quaternion& q0_WB, const TimeSpan& span);
  void integrate(const DrivenState& start, const TimeSpan& span, double tolerance_rad, double allowedSteps);
  RigidBodyState at(double t_s) const;
  double totalEnergy(const RigidBodyState& state) const {
    return state.kineticEnergy + potentialEnergy(forcing, state.q_WB);
  }
  std::optional<double> energyDrift(const TimeSpan& span) const;

  PrincipalAxes axes;
  Forcing forcing;
  std::optional<DecayingMotion> closed;
  std::optional<ChosenRun> run;
  DrivenMotionReport report;
};

void DrivenMotion::Solution::solveInClosedForm(const Eigen::Vector3d& omega0_B, const Quaternion& q0_WB,
                                               const TimeSpan& span) {
  const double d = forcing.dragRate_P[0];
  closed.emplace(axes, omega0_B, q0_WB, d);
  if (d > 0 && !closed->find(span.from_s))
    throw core::physicsError(
        fmt::format("{} s before its start a body with drag of {} 1/s would spin beyond the range of numbers; "
                    "start the run later",
                    -span.from_s, d));
  report.method = d == 0 ? "closed form" : "closed form in the time (1 - exp(-d t))/d";
  // Error bound of FreeMotion, plus the effect of rounding the time at which FreeMotion is evaluated.
  const double latest = std::max(-span.from_s, span.to_s);
  const double turned = axes.toP(omega0_B).cwiseAbs().maxCoeff() *
                        (d == 0 ? 0 : std::max(exponentialLessOne(-d * span.from_s) / d, std::min(latest, 1 / d)));
  report.estimatedAttitudeError_rad = 4e-15 + 0x1p-52 * turned;
  report.limitedByRounding = report.estimatedAttitudeError_rad > report.tolerance_rad;
}

void DrivenMotion::Solution::integrate(const DrivenState& start, const TimeSpan& span, double tolerance_rad,
                                       double allowedSteps) {
  run = chosenRun({axes, forcing, start, span.from_s, span.to_s, allowedSteps}, tolerance_rad);
  report.method = run->composition->name;
  report.order = run->composition->order;
  report.steps = run->forward.steps() + run->backward.steps();
  report.shortestStep_s = run->backward.steps() == 0 ? run->forward.shortestStep_s()
                          : run->forward.steps() == 0
                              ? run->backward.shortestStep_s()
                              : std::min(run->forward.shortestStep_s(), run->backward.shortestStep_s());
  report.estimatedAttitudeError_rad = run->error_rad;
  report.limitedByRounding = run->limitedByRounding;
  report.energyDrift = energyDrift(span);
}

std::optional<double> DrivenMotion::Solution::energyDrift(const TimeSpan& span) const {
  Forcing other = forcing;
  other.gravity_B.setZero();
  if (!other.none()) return std::nullopt;
  constexpr int kSamples = 200;
  const double start = totalEnergy(at(0));
  double largest = 0, scale = 0;
  for (int i = 0; i <= kSamples; ++i) {
    const double t = span.from_s + (span.to_s - span.from_s) * i / kSamples;
    const RigidBodyState state = at(std::clamp(t, span.from_s, span.to_s));  // rounding may put t outside the span
    largest = std::max(largest, std::abs(totalEnergy(state) - start));
    scale = std::max({scale, state.kineticEnergy, std::abs(potentialEnergy(forcing, state.q_WB))});
  }
  return scale > 0 ? largest / scale : 0;
}

RigidBodyState DrivenMotion::Solution::at(double t_s) const {
  if (closed) return closed->at(t_s);
  const double from_s = run->backward.end_s(), to_s = run->forward.end_s();
  if (!(from_s <= t_s && t_s <= to_s))
    throw core::limitError(
        fmt::format("t = {} s: this driven motion was computed only from {} s to {} s", t_s, from_s, to_s));
  const DrivenTrajectory& side = t_s < 0 ? run->backward : run->forward;
  const RigidBodyState state = bodyState(axes, side.at(t_s), t_s);
  if (!std::isfinite(state.kineticEnergy)) refuseTime(t_s);  // the energy may overflow even if L does not
  return state;
}

DrivenMotion::DrivenMotion(const PrincipalAxes& axes, const Eigen::Vector3d& omega0_B, const Quaternion& q0_WB,
                           const Forcing& forcing, const TimeSpan& span, double tolerance_rad,
                           double allowedSteps) {
  validate(forcing);
  requireSpan(span, tolerance_rad);
  const FreeMotion checked(axes, omega0_B, q0_WB);  // throws if the start is impossible
  const TimeSpan whole = {std::min({span.from_s, span.to_s, 0.0}), std::max({span.from_s, span.to_s, 0.0})};
  auto solution = std::make_unique<Solution>(axes, forcing);
  solution->report.tolerance_rad = tolerance_rad;
  if (hasClosedForm(forcing))
    solution->solveInClosedForm(omega0_B, q0_WB, whole);
  else
    solution->integrate(startOf(axes, omega0_B, q0_WB), whole, tolerance_rad, allowedSteps);
  solution_ = std::move(solution);
}

DrivenMotion::~DrivenMotion() = default;
DrivenMotion::DrivenMotion(DrivenMotion&&) noexcept = default;
DrivenMotion& DrivenMotion::operator=(DrivenMotion&&) noexcept = default;

const DrivenMotion::Solution& DrivenMotion::solution() const {
  POINSOT_EXPECT(solution_ != nullptr);
  return *solution_;
}

RigidBodyState DrivenMotion::at(double t_s) const { return solution().at(t_s); }
const PrincipalAxes& DrivenMotion::axes() const { return solution().axes; }
const Forcing& DrivenMotion::forcing() const { return solution().forcing; }
const DrivenMotionReport& DrivenMotion::report() const { return solution().report; }
TimeSpan DrivenMotion::span() const {
  if (solution().closed) return {-HUGE_VAL, HUGE_VAL};
  return {solution().run->backward.end_s(), solution().run->forward.end_s()};
}
double DrivenMotion::totalEnergy(const RigidBodyState& state) const { return solution().totalEnergy(state); }

}  // namespace poinsot::physics
