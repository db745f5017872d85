// SPDX-License-Identifier: Apache-2.0
#include "physics/motion_events.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>

#include "core/error.h"
#include "core/interruption.h"
#include "physics/heavy_top.h"
#include "physics/stability.h"

namespace poinsot::physics {
namespace {

using Eigen::Vector3d;
using Kind = MotionEventKind;

constexpr double kMostFlips = 1e6, kMostSamples = 4e6;
constexpr double kSamplesPerRadian = 4;
constexpr int kSpeedPoints = 1000;
constexpr double kStill = 1e-10;  // smallest change that counts, relative to omega or to L^2

/// Ends of a span in ascending order.
struct Range {
  double from_s, to_s;
};

/// Function of the motion whose changes of sign are events.
struct Crossing {
  std::function<double(double)> value;     ///< value at a motion time, relative to a scale of the motion
  std::function<Kind(double, bool)> kind;  ///< kind of a root at a motion time; true if the value rises
  bool atEnds;                             ///< whether a root at an end of the span is an event
};

/// Returns the index of the middle moment, or nothing if two moments are equal.
std::optional<int> middleAxis(const PrincipalMoments& moments) {
  std::array<int, 3> order{0, 1, 2};
  std::ranges::sort(order, {}, [&](int axis) { return moments[axis]; });
  const bool distinct = moments[order[0]] < moments[order[1]] && moments[order[1]] < moments[order[2]];
  return distinct ? std::optional(order[1]) : std::nullopt;
}

Vector3d omega_P(const Motion& motion, double t_s) { return motion.axes().toP(motion.at(t_s).omega_B); }

/// Returns the component of omega along a principal axis, relative to |omega|; 0 at rest.
double share(const Motion& motion, int axis, double t_s) {
  const Vector3d omega = omega_P(motion, t_s);
  const double size = omega.norm();
  return size > 0 ? omega[axis] / size : 0;
}

/// Returns the root of a function between two times at which it has different signs, to the last bit.
double root(const std::function<double(double)>& value, double from_s, double to_s) {
  const bool rises = value(to_s) > 0;
  for (;;) {
    const double middle_s = std::midpoint(from_s, to_s);
    if (middle_s <= from_s || middle_s >= to_s) return to_s;
    ((value(middle_s) > 0) == rises ? to_s : from_s) = middle_s;
  }
}

bool differ(double a, double b) { return (a < 0 && b > 0) || (a > 0 && b < 0); }

Kind kindOfFlip(const Motion& motion, double t_s) {
  return flipTimes(motion.axes().moments(), omega_P(motion, t_s)).turnsOver ? Kind::kFlip : Kind::kReversal;
}

/// Returns the first flip of a free motion at or after a time. @param interval_s  time from flip to flip
double firstFlip(const std::function<double(double)>& value, double from_s, double interval_s) {
  const double at = value(from_s), next = value(from_s + interval_s);
  if (at == 0 || !differ(at, next)) return from_s;  // a flip within rounding of both ends
  return root(value, from_s, from_s + interval_s);
}

std::vector<MotionEvent> freeEvents(const Motion& motion, const Range& range) {
  const auto axis = middleAxis(motion.axes().moments());
  if (!axis) return {};
  const FlipTimes flips = flipTimes(motion.axes().moments(), omega_P(motion, range.from_s));
  const auto value = [&](double t_s) { return share(motion, *axis, t_s); };
  const Kind kind = flips.turnsOver ? Kind::kFlip : Kind::kReversal;
  if (flips.interval_s == 0) return {};
  if (std::isinf(flips.interval_s)) {
    if (value(range.from_s) == 0) return {{kind, range.from_s}};
    if (!differ(value(range.from_s), value(range.to_s))) return {};
    return {{kind, root(value, range.from_s, range.to_s)}};
  }
  if ((range.to_s - range.from_s) / flips.interval_s > kMostFlips)
    throw core::limitError(
        fmt::format("from t = {:.6g} s to {:.6g} s there are more than {:.0e} flips; choose a "
                    "shorter span",
                    range.from_s, range.to_s, kMostFlips));
  std::vector<MotionEvent> events;
  const double first_s = firstFlip(value, range.from_s, flips.interval_s);
  for (double k = 0; first_s + k * flips.interval_s <= range.to_s; ++k)
    events.push_back({kind, first_s + k * flips.interval_s});
  return events;
}

Crossing flipsOf(const Motion& motion, int axis) {
  return {[&motion, axis](double t_s) { return share(motion, axis, t_s); },
          [&motion](double t_s, bool) { return kindOfFlip(motion, t_s); }, true};
}

Crossing separatrixOf(const Motion& motion, int axis) {
  const double middle = motion.axes().moments()[axis];
  return {[&motion, middle](double t_s) {
            const RigidBodyState state = motion.at(t_s);
            const double square = state.L_W.squaredNorm();
            return square > 0 ? (square - 2 * state.kineticEnergy * middle) / square : 0;
          },
          [](double, bool) { return Kind::kSeparatrix; }, false};
}

/// Crossings of the rate at which the cosine of the tilt changes, relative to the rate of turning.
Crossing tiltOf(const Motion& motion, const HeavyTop& top) {
  const Vector3d k_B = motion.axes().toB(top.k_P);
  return {[&motion, k_B](double t_s) {
            const RigidBodyState state = motion.at(t_s);
            const Vector3d rate_W = turningRate_W(motion, state);
            const double size = rate_W.norm();
            return size > 0 ? rate_W.cross(state.q_WB * k_B).z() / size : 0;
          },
          [](double, bool rises) { return rises ? Kind::kMostTilt : Kind::kLeastTilt; }, true};
}

std::vector<Crossing> crossingsOf(const Motion& motion, const Forcing& forcing) {
  if (!forcing.gravity_B.isZero(0)) {
    const auto top = heavyTop(motion.axes().moments(), motion.axes().toP(forcing.gravity_B));
    return top ? std::vector{tiltOf(motion, *top)} : std::vector<Crossing>();
  }
  const auto axis = middleAxis(motion.axes().moments());
  return axis ? std::vector{flipsOf(motion, *axis), separatrixOf(motion, *axis)} : std::vector<Crossing>();
}

double fraction(const Range& range, double part) { return std::lerp(range.from_s, range.to_s, part); }

/// Returns the number of samples that follow every swing of the motion.
double samplesFor(const Motion& motion, const Range& range) {
  double fastest = 0;
  for (int i = 0; i <= kSpeedPoints; ++i)
    fastest = std::max(fastest, motion.at(fraction(range, static_cast<double>(i) / kSpeedPoints)).omega_B.norm());
  const double count = kSamplesPerRadian * fastest * (range.to_s - range.from_s);
  if (count > kMostSamples)
    throw core::limitError(
        fmt::format("from t = {:.6g} s to {:.6g} s the body turns by more than {:.0e} rad, too many to find all "
                    "events; choose a shorter span",
                    range.from_s, range.to_s, kMostSamples / kSamplesPerRadian));
  return std::max(std::ceil(count), static_cast<double>(kSpeedPoints));
}

void addCrossings(const Crossing& crossing, const Range& range, double samples, std::vector<MotionEvent>& events) {
  double before_s = range.from_s, before = 0;  // the latest sample that is not 0
  bool wasMoving = false;                      // whether the previous sample is not 0
  for (double i = 0; i <= samples; ++i) {
    core::checkInterruption();
    const double t_s = fraction(range, i / samples), value = crossing.value(t_s);
    const bool still = std::abs(value) <= kStill;
    if (still && i == samples && crossing.atEnds && wasMoving)
      events.push_back({crossing.kind(t_s, before < 0), t_s});
    wasMoving = !still;
    if (still) continue;
    if (i == 1 && before == 0 && crossing.atEnds)
      events.push_back({crossing.kind(range.from_s, value > 0), range.from_s});
    if (differ(before, value)) {
      const double at_s = root(crossing.value, before_s, t_s);
      events.push_back({crossing.kind(at_s, value > 0), at_s});
    }
    before_s = t_s;
    before = value;
  }
}

std::vector<MotionEvent> drivenEvents(const Motion& motion, const Forcing& forcing, const Range& range) {
  const std::vector<Crossing> crossings = crossingsOf(motion, forcing);
  if (crossings.empty()) return {};
  const double samples = samplesFor(motion, range);
  std::vector<MotionEvent> events;
  for (const Crossing& crossing : crossings) addCrossings(crossing, range, samples, events);
  std::ranges::stable_sort(events, {}, &MotionEvent::t_s);
  return events;
}

}  // namespace

std::vector<MotionEvent> motionEvents(const Motion& motion, const Forcing& forcing, const TimeSpan& span) {
  const Range range{std::min(span.from_s, span.to_s), std::max(span.from_s, span.to_s)};
  std::vector<MotionEvent> events =
      forcing.none() ? freeEvents(motion, range) : drivenEvents(motion, forcing, range);
  if (span.to_s < span.from_s) std::ranges::reverse(events);
  return events;
}

}  // namespace poinsot::physics
