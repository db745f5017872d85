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

/// A free body, and the start that logs of it have.
extern const Eigen::Vector3d kLoggedMoments;
extern const EngineState kLoggedStart;

std::unique_ptr<const physics::Motion> loggedMotion();

/// One row of somebody's log.
struct LogRow {
  double t_s = 0;
  Eigen::Quaterniond q;
  Eigen::Vector3d omega_B;
};

/// How somebody writes the true state down.
using LogWriter = std::function<LogRow(const physics::RigidBodyState&)>;

enum class Holds { kBoth, kAttitude, kOmega };

/// 100 rows of a motion, 0.3 s apart, as CSV.
std::string logOf(const physics::Motion& motion, const LogWriter& writer, Holds holds = Holds::kBoth,
                  int digits = 17);
/// The same of loggedMotion().
std::string logOf(const LogWriter& writer, Holds holds = Holds::kBoth);

/// Grades a log against loggedMotion().
Grade gradeOfLog(const std::string& csv);

/// Largest error of all quantities once the log is read as the note says; infinite where it says nothing.
double largestLeft(const Grade& grade);

/// Expects that the one note names this cause alone, and that it leaves rounding.
void expectCause(const std::string& csv, const std::string& condition);

/// The quaternion whose w, x, y, z are x, y, z, w of another.
Eigen::Quaterniond scalarLast(const Eigen::Quaterniond& q);

}  // namespace poinsot::reference
