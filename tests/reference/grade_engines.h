// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <functional>
#include <string>

namespace poinsot::reference {

/// What an engine keeps of a body that turns freely.
struct EngineState {
  Eigen::Quaterniond q_WB = Eigen::Quaterniond::Identity();
  Eigen::Vector3d omega_B = Eigen::Vector3d::Zero();
};

/// One step of h seconds of a body with these principal moments.
using EngineStep = std::function<EngineState(const Eigen::Vector3d& moments, const EngineState&, double h)>;

/// Euler's equations (24) to (26) and q' = q omega / 2, both from the old state; q renormalised.
EngineState explicitEuler(const Eigen::Vector3d& moments, const EngineState& s, double h);
/// The same, but q from the new omega.
EngineState semiImplicitEuler(const Eigen::Vector3d& moments, const EngineState& s, double h);
/// The classical Runge-Kutta step of order 4 for both.
EngineState rungeKutta(const Eigen::Vector3d& moments, const EngineState& s, double h);

/// t, q and omega_B at every `every`-th of `steps` steps, as CSV with `digits` significant digits.
std::string engineCsv(const EngineStep& step, const Eigen::Vector3d& moments, EngineState s, double h, int steps,
                      int every, int digits = 17);

}  // namespace poinsot::reference
