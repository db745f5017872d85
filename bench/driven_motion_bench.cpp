// SPDX-License-Identifier: Apache-2.0
// Benchmarks of driven motion: time per free flow over a short step, per step of each composition, per state at a
// random time, and to integrate 20 s.
#include <benchmark/benchmark.h>

#include "physics/driven_motion.h"
#include "physics/splitting.h"

namespace poinsot::physics {
namespace {

const Eigen::Vector3d kMoments(1, 1.5, 2), kOmega0(0.5, 1, 2);

DrivenState start() {
  DrivenState state;
  state.L_W = {kMoments[0] * kOmega0[0], kMoments[1] * kOmega0[1], kMoments[2] * kOmega0[2]};
  return state;
}

Forcing gravity() {
  Forcing forcing;
  forcing.gravity_B = {0.3, 0.5, 1};
  return forcing;
}

Forcing everything() {
  Forcing forcing = gravity();
  forcing.torque_B = {0.1, -0.2, 0.1};
  forcing.torque_W = {0.2, 0.1, 0};
  forcing.dragRate_P = {0.03, 0.01, 0.02};
  forcing.dissipation = 0.005;
  return forcing;
}

void freeFlow(benchmark::State& state) {
  const FreeFlow flow{PrincipalMoments(kMoments)};
  DrivenState body = start();
  for (auto _ : state) flow.apply(body, 0.005);
  benchmark::DoNotOptimize(body);
}
BENCHMARK(freeFlow);

void step(benchmark::State& state, const Composition& composition, const Forcing& forcing) {
  const Splitting splitting(PrincipalMoments(kMoments), forcing);
  DrivenState body = start();
  for (auto _ : state) splitting.step(body, composition, {}, 0, 0.03);
  benchmark::DoNotOptimize(body);
}
BENCHMARK_CAPTURE(step, order_6_gravity, nystrom6(), gravity());
BENCHMARK_CAPTURE(step, order_8_gravity, kahanLi8(), gravity());
BENCHMARK_CAPTURE(step, order_8_everything, kahanLi8(), everything());

DrivenMotion motion(const Forcing& forcing) {
  return {PrincipalMoments(kMoments), kOmega0, Eigen::Quaterniond::Identity(), forcing, {0, 20}};
}

void stateAt(benchmark::State& state, const Forcing& forcing) {
  const DrivenMotion driven = motion(forcing);
  double t = 0.1;
  for (auto _ : state) {
    benchmark::DoNotOptimize(driven.at(t));
    t = t < 10 ? 1.618 * t : 0.1;
  }
}
BENCHMARK_CAPTURE(stateAt, gravity, gravity());
BENCHMARK_CAPTURE(stateAt, everything, everything());

void integrate20Seconds(benchmark::State& state, const Forcing& forcing) {
  for (auto _ : state) benchmark::DoNotOptimize(motion(forcing));
}
BENCHMARK_CAPTURE(integrate20Seconds, gravity, gravity());
BENCHMARK_CAPTURE(integrate20Seconds, everything, everything());

}  // namespace
}  // namespace poinsot::physics
