// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <functional>
#include <string>

namespace poinsot::reference {

struct EngineState {
  Eigen::Quaterniond q_WB = Eigen::Quaterniond::Identity();
  Eigen::Vector3d omega_B = Eigen::Vector3d::Zero();
};

/// Function that advances a body with these principal moments by h seconds.
using EngineStep = std::function<EngineState(const Eigen::Vector3d& moments, const EngineState&, double h)>;

/// Steps Euler's equations (24) to (26) and q' = q omega / 2, both from the old state; renormalises q.
EngineState explicitEuler(const Eigen::Vector3d& moments, const EngineState& s, double h);
/// Steps as explicitEuler(), but turns q with the new omega.
EngineState semiImplicitEuler(const Eigen::Vector3d& moments, const EngineState& s, double h);
/// Steps q and omega with the classical Runge-Kutta method of order 4.
EngineState rungeKutta(const Eigen::Vector3d& moments, const EngineState& s, double h);

/// Returns t, q and omega_B at every `every`-th of `steps` steps, as CSV with `digits` significant digits.
std::string engineCsv(const EngineStep& step, const Eigen::Vector3d& moments, EngineState s, double h, int steps,
                      int every, int digits = 17);

}  // namespace poinsot::reference
