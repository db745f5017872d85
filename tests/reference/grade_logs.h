// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <functional>
#include <memory>
#include <string>

#include "reference/grade.h"
#include "reference/grade_engines.h"

namespace poinsot::reference {

/// Principal moments and start of the free body in the logs.
extern const Eigen::Vector3d kLoggedMoments;
extern const EngineState kLoggedStart;

std::unique_ptr<const physics::Motion> loggedMotion();

struct LogRow {
  double t_s = 0;
  Eigen::Quaterniond q;
  Eigen::Vector3d omega_B;
};

/// Convention in which a log writes down the true state.
using LogWriter = std::function<LogRow(const physics::RigidBodyState&)>;

enum class Holds { kBoth, kAttitude, kOmega };

/// Returns 100 rows of a motion, 0.3 s apart, as CSV.
std::string logOf(const physics::Motion& motion, const LogWriter& writer, Holds holds = Holds::kBoth,
                  int digits = 17);
std::string logOf(const LogWriter& writer, Holds holds = Holds::kBoth);

Grade gradeOfLog(const std::string& csv);

/// Returns the largest error of all quantities in the convention that fits; infinite if none was found.
double largestLeft(const Grade& grade);

/// Expects a single note with this cause alone, and only rounding errors in that convention.
void expectCause(const std::string& csv, const std::string& condition);

/// Returns the quaternion whose w, x, y, z are x, y, z, w of `q`.
Eigen::Quaterniond scalarLast(const Eigen::Quaterniond& q);

}  // namespace poinsot::reference
