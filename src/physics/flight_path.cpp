// SPDX-License-Identifier: Apache-2.0
#include "physics/flight_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/error.h"
#include "core/interruption.h"
#include "physics/driven_motion.h"
#include "physics/fixed_order.h"
#include "physics/forcing_piece.h"
#include "physics/rotor.h"
#include "physics/torque.h"
#include "physics/transcendental.h"

namespace poinsot::physics {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kNodes = 16;  // Chebyshev nodes of an interval
constexpr std::size_t kMostIntervals = 200000;
// Largest turn between two neighbouring nodes. After a full turn between nodes, a force that turns with the body
// would look constant.
constexpr double kLongestTurn_rad = 0.5;
constexpr double kFinest = 1e-13;    // smallest tolerance of the direction of a force
constexpr double kShortest = 1e-10;  // shortest interval, relative to its distance from time 0

using Chebyshev = std::vector<Vector3d>;  // coefficients of Chebyshev polynomials in u, from -1 to 1

/// Returns the sum of c_k T_k(u), by Clenshaw's recurrence.
Vector3d sumOf(const Chebyshev& c, double u) {
  Vector3d b1 = Vector3d::Zero(), b2 = Vector3d::Zero();
  for (std::size_t k = c.size(); k-- > 1;) {
    const Vector3d b = c[k] + 2 * u * b1 - b2;
    b2 = b1;
    b1 = b;
  }
  return c.empty() ? b1 : Vector3d(c[0] + u * b1 - b2);
}

/// Returns the integral of a series over u from -1.
Chebyshev integralOf(const Chebyshev& c) {
  if (c.empty()) return {};
  const auto at = [&](std::size_t k) { return k < c.size() ? c[k] : Vector3d(Vector3d::Zero()); };
  Chebyshev integral(c.size() + 1, Vector3d::Zero());
  integral[1] = at(0) - 0.5 * at(2);
  for (std::size_t k = 2; k < integral.size(); ++k)
    integral[k] = (at(k - 1) - at(k + 1)) / (2 * static_cast<double>(k));
  for (std::size_t k = 1; k < integral.size(); ++k) integral[0] += (k % 2 == 1 ? 1 : -1) * integral[k];
  return integral;
}

/// Nodes of an interval, and the cosines of the transformation from values to coefficients.
struct Nodes {
  std::array<double, kNodes> u{};
  std::array<std::array<double, kNodes>, kNodes> cosine{};  // cos(k theta_j)

  Nodes() {
    for (std::size_t j = 0; j < kNodes; ++j) {
      for (std::size_t k = 0; k < kNodes; ++k) {
        const double halfSteps = static_cast<double>(k * (2 * j + 1) % (4 * kNodes));  // of pi/(2 kNodes)
        cosine[k][j] = sineCosine(kPi * DoubleDouble(halfSteps / (2 * kNodes))).cosine;
      }
      u[j] = cosine[1][j];
    }
  }
};

const Nodes& nodes() {
  static const Nodes all;
  return all;
}

Chebyshev seriesThrough(const std::array<Vector3d, kNodes>& values) {
  Chebyshev c(kNodes, Vector3d::Zero());
  for (std::size_t k = 0; k < kNodes; ++k) {
    for (std::size_t j = 0; j < kNodes; ++j) c[k] += nodes().cosine[k][j] * values[j];
    c[k] *= (k == 0 ? 1.0 : 2.0) / kNodes;
  }
  return c;
}

/// Interval of time in which the acceleration by forces is a series. Velocity and displacement are the changes by
/// forces since motion time 0.
struct Interval {
  double begin_s = 0, end_s = 0;
  Vector3d velocity = Vector3d::Zero(), displacement = Vector3d::Zero();  // at begin_s
  Chebyshev speeds, places;  // integral and double integral of the acceleration, over u

  double half_s() const { return 0.5 * (end_s - begin_s); }
  double u(double t_s) const { return std::clamp((t_s - begin_s) / half_s() - 1, -1.0, 1.0); }
  Vector3d velocityAt(double t_s) const { return velocity + half_s() * sumOf(speeds, u(t_s)); }
  Vector3d displacementAt(double t_s) const {
    return displacement + (t_s - begin_s) * velocity + half_s() * half_s() * sumOf(places, u(t_s));
  }
};

/// Sums of the forces that act in a piece, divided by the mass.
struct Push {
  Vector3d body_B = Vector3d::Zero(), space_W = Vector3d::Zero();
};

/// Integrates the acceleration by forces from time 0 to one end of the span.
class Side {
 public:
  Side(double mass_kg, const DrivenMotion& motion, double end_s)
      : mass_kg_(mass_kg), motion_(motion), tolerance_(std::max(kFinest, motion.report().tolerance_rad)) {
    const std::vector<double> times = end_s == 0 ? std::vector<double>() : forcingTimes(motion.forcing(), end_s);
    for (std::size_t i = 0; i + 1 < times.size(); ++i) addPiece(times[i], times[i + 1]);
  }

  std::vector<Interval> intervals() && { return std::move(intervals_); }

 private:
  void addPiece(double begin, double end) {
    const double inside = begin + 0.5 * (end - begin);
    Push push;
    for (const PointForce& force : motion_.forcing().forces)
      if (force.actsAt(inside)) {
        push.body_B += force.force_B / mass_kg_;
        push.space_W += force.force_W / mass_kg_;
      }
    if (push.body_B.isZero(0))
      append(begin, end, push.space_W.isZero(0) ? Chebyshev() : Chebyshev{push.space_W});
    else
      expand(begin, end, push);
  }

  void expand(double begin, double end, const Push& push) {
    core::checkInterruption();
    bool isFine = false;
    Chebyshev series = acceleration(begin, end, push, isFine);
    const double length = std::abs(end - begin);
    if (isFine || length <= kShortest * std::max(std::abs(begin), std::abs(end)))
      return append(begin, end, std::move(series));
    const double middle = begin + 0.5 * (end - begin);
    expand(begin, middle, push);
    expand(middle, end, push);
  }

  Chebyshev acceleration(double begin, double end, const Push& push, bool& isFine) const {
    std::array<Vector3d, kNodes> values;
    const double half = 0.5 * (end - begin);
    double fastest = 0;
    for (std::size_t j = 0; j < kNodes; ++j) {
      const RigidBodyState state = motion_.at(begin + half * (1 + nodes().u[j]));
      fastest = std::max(fastest, std::sqrt(dotProduct(state.omega_B, state.omega_B)));
      values[j] = rotated(state.q_WB, push.body_B);
    }
    Chebyshev series = seriesThrough(values);
    const double bound = tolerance_ * std::sqrt(dotProduct(push.body_B, push.body_B));
    isFine = fastest * std::abs(end - begin) <= kLongestTurn_rad * kNodes / 2;
    for (std::size_t k = kNodes - 3; k < kNodes; ++k) isFine = isFine && series[k].cwiseAbs().maxCoeff() <= bound;
    series[0] += push.space_W;
    return series;
  }

  void append(double begin, double end, Chebyshev acceleration) {
    if (intervals_.size() >= kMostIntervals)
      throw core::limitError(
          fmt::format("the flight needs more than {} intervals to integrate a force that turns with the body; "
                      "shorten the run, or the time in which the force acts",
                      kMostIntervals));
    Interval next{begin, end, Vector3d::Zero(), Vector3d::Zero(), integralOf(acceleration), {}};
    next.places = integralOf(next.speeds);
    if (!intervals_.empty()) {
      next.velocity = intervals_.back().velocityAt(begin);
      next.displacement = intervals_.back().displacementAt(begin);
    }
    intervals_.push_back(std::move(next));
  }

  double mass_kg_;
  const DrivenMotion& motion_;
  double tolerance_;
  std::vector<Interval> intervals_;
};

void requireFlightMass(double mass_kg) {
  if (!(mass_kg > 0 && std::isfinite(mass_kg)))
    throw core::physicsError(
        fmt::format("a force moves the centre of mass of a body with a positive mass, got {} kg", mass_kg));
}

Vector3d finiteAt(const Vector3d& v_W, double t_s) {
  if (!v_W.allFinite()) refuseTime(t_s);
  return v_W;
}

}  // namespace

struct FlightPath::Pushed {
  double from_s = 0, to_s = 0;
  std::vector<Interval> forward, backward;

  const Interval* at(double t_s) const {
    if (!(from_s <= t_s && t_s <= to_s))
      throw core::limitError(
          fmt::format("t = {} s: this flight was computed only from {} s to {} s", t_s, from_s, to_s));
    if (t_s == 0) return nullptr;
    const std::vector<Interval>& side = t_s < 0 ? backward : forward;
    const auto before = [&](const Interval& interval) { return std::abs(interval.end_s) < std::abs(t_s); };
    return &*std::partition_point(side.begin(), side.end(), before);
  }
};

FlightPath::FlightPath(const Flight& flight, double mass_kg, const Motion& motion) : gravity_(flight) {
  const DrivenMotion* driven = motion.driven();
  if (!driven || driven->forcing().forces.empty()) return;
  requireFlightMass(mass_kg);
  auto pushed = std::make_shared<Pushed>();
  pushed->from_s = driven->span().from_s;
  pushed->to_s = driven->span().to_s;
  pushed->forward = Side(mass_kg, *driven, pushed->to_s).intervals();
  pushed->backward = Side(mass_kg, *driven, pushed->from_s).intervals();
  pushed_ = std::move(pushed);
}

Vector3d FlightPath::positionAt(double t_s) const {
  const Vector3d falling = gravity_.positionAt(t_s);
  const Interval* interval = pushed_ ? pushed_->at(t_s) : nullptr;
  return interval ? finiteAt(falling + interval->displacementAt(t_s), t_s) : falling;
}

Vector3d FlightPath::velocityAt(double t_s) const {
  const Vector3d falling = gravity_.velocityAt(t_s);
  const Interval* interval = pushed_ ? pushed_->at(t_s) : nullptr;
  return interval ? finiteAt(falling + interval->velocityAt(t_s), t_s) : falling;
}

FlightQuantities flightQuantities(double mass_kg, const FlightPath& path, const Forcing& forcing,
                                  const PrincipalAxes& axes, const RigidBodyState& state) {
  // The flight that gravity alone would give, with the position and the velocity of this instant.
  Flight now = path.gravityAlone();
  if (path.hasForces()) {
    now.position_W = path.positionAt(state.t_s);
    now.velocity_W = path.velocityAt(state.t_s);
    RigidBodyState atZero = state;
    atZero.t_s = 0;
    FlightQuantities q = flightQuantities(mass_kg, now, atZero);
    const Vector3d force_W = totalForce_W(forcing, state);
    q.force_W += force_W;
    q.torque_W += crossProduct(now.position_W, force_W) + torque_W(forcing, axes, state);
    return q;
  }
  FlightQuantities q = flightQuantities(mass_kg, now, state);
  if (!forcing.none()) q.torque_W += torque_W(forcing, axes, state);
  return q;
}

}  // namespace poinsot::physics
