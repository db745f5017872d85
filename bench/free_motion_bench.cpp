// SPDX-License-Identifier: Apache-2.0
// Benchmarks of free motion: time per state at a random time, and per construction, for each kind of motion.
#include <benchmark/benchmark.h>

#include "physics/free_motion.h"

namespace poinsot::physics {
namespace {

void evaluate(benchmark::State& state, const Eigen::Vector3d& moments, const Eigen::Vector3d& omega_B) {
  const FreeMotion motion(PrincipalMoments(moments), omega_B, Eigen::Quaterniond::Identity());
  double t = 0.1;
  for (auto _ : state) {
    benchmark::DoNotOptimize(motion.at(t));
    t = t < 1e6 ? 1.618 * t : 0.1;  // all times differ, and none is near the previous one
  }
}

BENCHMARK_CAPTURE(evaluate, about_largest_axis, Eigen::Vector3d(2, 3, 4), Eigen::Vector3d(0.5, 0.25, 1));
BENCHMARK_CAPTURE(evaluate, about_smallest_axis, Eigen::Vector3d(2, 3, 4), Eigen::Vector3d(1, 0.25, 0.25));
BENCHMARK_CAPTURE(evaluate, separatrix, Eigen::Vector3d(1, 2, 2.25), Eigen::Vector3d(0.75, 0.5, 1));
BENCHMARK_CAPTURE(evaluate, flipping, Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(0x1p-10, 1, 0));
BENCHMARK_CAPTURE(evaluate, symmetric, Eigen::Vector3d(1.5, 1.5, 0.9), Eigen::Vector3d(0.5, 0, 2));
BENCHMARK_CAPTURE(evaluate, near_separatrix, Eigen::Vector3d(1, 2, 2.25), Eigen::Vector3d(0.75, 0.5, 1 + 0x1p-45));
BENCHMARK_CAPTURE(evaluate, needle, Eigen::Vector3d(1e-3, 1, 1.0005), Eigen::Vector3d(1, 0.5, 0.25));
BENCHMARK_CAPTURE(evaluate, steady, Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(0, 0, 1));

void construct(benchmark::State& state, const Eigen::Vector3d& moments, const Eigen::Vector3d& omega_B) {
  const PrincipalMoments principal(moments);
  for (auto _ : state) benchmark::DoNotOptimize(FreeMotion(principal, omega_B, Eigen::Quaterniond::Identity()));
}

BENCHMARK_CAPTURE(construct, about_largest_axis, Eigen::Vector3d(2, 3, 4), Eigen::Vector3d(0.5, 0.25, 1));
BENCHMARK_CAPTURE(construct, near_separatrix, Eigen::Vector3d(1, 2, 2.25),
                  Eigen::Vector3d(0.75, 0.5, 1 + 0x1p-45));
BENCHMARK_CAPTURE(construct, steady, Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(0, 0, 1));

}  // namespace
}  // namespace poinsot::physics
