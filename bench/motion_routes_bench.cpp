// SPDX-License-Identifier: Apache-2.0
// Benchmarks beside free_motion_bench.cpp: a state by the classical formulas with Boost, and one step of an
// integrator. Each reports its deviation from FreeMotion (itself tested to 4e-15 rad) as error_rad.
#include <benchmark/benchmark.h>

#include <array>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include "classical_route.h"
#include "physics/free_motion.h"

namespace poinsot::physics {
namespace {

struct Start {
  Eigen::Vector3d I, omega0;
};
const Start kAboutLargest{{2, 3, 4}, {0.5, 0.25, 1}};
const Start kAboutSmallest{{2, 3, 4}, {1, 0.25, 0.25}};
const Start kFlipping{{1, 2, 3}, {0x1p-10, 1, 0}};
const Start kNearSeparatrix{{1, 2, 2.25}, {0.75, 0.5, 1 + 0x1p-45}};
const Start kNeedle{{1e-3, 1, 1.0005}, {1, 0.5, 0.25}};

FreeMotion exact(const Start& start) {
  return FreeMotion(PrincipalMoments(start.I), start.omega0, Eigen::Quaterniond::Identity());
}

double angleBetween(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  const Eigen::Quaterniond d = a.conjugate() * b;
  return 2 * std::atan2(d.vec().norm(), std::abs(d.w()));
}

void boostClassical(benchmark::State& state, const Start& start) {
  const ClassicalRoute motion(start.I, start.omega0, Eigen::Quaterniond::Identity());
  double t = 0.1;
  for (auto _ : state) {
    benchmark::DoNotOptimize(motion.at(t));
    t = t < 1e3 ? 1.618 * t : 0.1;
  }
  double error = 0;
  for (double s = 0.1; s < 1e3; s *= 1.618)
    error = std::max(error, angleBetween(motion.at(s), exact(start).at(s).q_WB));
  state.counters["error_rad"] = error;
}
BENCHMARK_CAPTURE(boostClassical, about_largest_axis, kAboutLargest);
BENCHMARK_CAPTURE(boostClassical, about_smallest_axis, kAboutSmallest);
BENCHMARK_CAPTURE(boostClassical, flipping, kFlipping);
BENCHMARK_CAPTURE(boostClassical, near_separatrix, kNearSeparatrix);
BENCHMARK_CAPTURE(boostClassical, needle, kNeedle);

/// State of the integrators: omega in body axes, then the quaternion w, x, y, z.
using Unknowns = std::array<double, 7>;

struct EulerEquations {
  Eigen::Vector3d I;

  void operator()(const Unknowns& s, Unknowns& rate, double) const {
    const auto& [p, q, r, w, x, y, z] = s;
    rate = {(I[1] - I[2]) / I[0] * q * r,   (I[2] - I[0]) / I[1] * r * p,  (I[0] - I[1]) / I[2] * p * q,
            0.5 * (-x * p - y * q - z * r), 0.5 * (w * p + y * r - z * q), 0.5 * (w * q + z * p - x * r),
            0.5 * (w * r + x * q - y * p)};
  }
};

/// Measures one step, and reports the error after 100 s of steps of this length.
template <typename Stepper>
void integratorStep(benchmark::State& state, double step_s) {
  const EulerEquations equations{kAboutLargest.I};
  const Eigen::Vector3d& w = kAboutLargest.omega0;
  Stepper stepper;
  Unknowns s{w[0], w[1], w[2], 1, 0, 0, 0};
  const int steps = static_cast<int>(std::lround(100 / step_s));
  for (int i = 0; i < steps; ++i) stepper.do_step(equations, s, 0, step_s);
  const Eigen::Quaterniond q = Eigen::Quaterniond(s[3], s[4], s[5], s[6]).normalized();
  state.counters["error_rad"] = angleBetween(q, exact(kAboutLargest).at(100).q_WB);
  state.counters["steps_to_100s"] = steps;
  for (auto _ : state) {
    stepper.do_step(equations, s, 0, step_s);
    benchmark::DoNotOptimize(s);
  }
}
void stepOfRk4(benchmark::State& state) {
  integratorStep<boost::numeric::odeint::runge_kutta4<Unknowns>>(state, 1.0 / 128);
}
BENCHMARK(stepOfRk4);

void stepOfFehlberg78(benchmark::State& state) {
  integratorStep<boost::numeric::odeint::runge_kutta_fehlberg78<Unknowns>>(state, 0.25);
}
BENCHMARK(stepOfFehlberg78);

}  // namespace
}  // namespace poinsot::physics
