// SPDX-License-Identifier: Apache-2.0
#include "reference/grade_logs.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "physics/free_motion.h"

namespace poinsot::reference {

using Eigen::Quaterniond;
using Eigen::Vector3d;

const Vector3d kLoggedMoments{2, 3, 4};
const EngineState kLoggedStart{Quaterniond(.9, .1, -.3, .2).normalized(), Vector3d(.5, .25, 1)};

std::unique_ptr<const physics::Motion> loggedMotion() {
  return std::make_unique<physics::FreeMotion>(physics::PrincipalMoments(kLoggedMoments), kLoggedStart.omega_B,
                                               kLoggedStart.q_WB);
}

Grade gradeOfLog(const std::string& csv) {
  return grade(*loggedMotion(), parseTrajectoryTable(csv, "theirs.csv"),
               [](const physics::TimeSpan&) { return loggedMotion(); });
}

std::string logOf(const physics::Motion& motion, const LogWriter& writer, Holds holds, int digits) {
  std::string csv = "t";
  if (holds != Holds::kOmega) csv += ",q_w,q_x,q_y,q_z";
  if (holds != Holds::kAttitude) csv += ",omega_B_x,omega_B_y,omega_B_z";
  for (int i = 0; i < 100; ++i) {
    const LogRow row = writer(motion.at(0.3 * i));
    std::vector<double> values;
    if (holds != Holds::kOmega) values = {row.q.w(), row.q.x(), row.q.y(), row.q.z()};
    if (holds != Holds::kAttitude) values.insert(values.end(), row.omega_B.begin(), row.omega_B.end());
    csv += fmt::format("\n{:.17g}", row.t_s);
    for (const double value : values) csv += fmt::format(",{:.{}g}", value, digits);
  }
  return csv;
}

std::string logOf(const LogWriter& writer, Holds holds) { return logOf(*loggedMotion(), writer, holds); }

double largestLeft(const Grade& grade) {
  double largest = grade.fit ? 0 : INFINITY;
  if (grade.fit)
    for (const GradedQuantity& quantity : grade.fit->quantities)
      if (quantity.errors) largest = std::max(largest, quantity.errors->largest);
  return largest;
}

void expectCause(const std::string& csv, const std::string& condition) {
  const Grade grade = gradeOfLog(csv);
  EXPECT_THAT(grade.notes, testing::ElementsAre(testing::StartsWith("fits if " + condition + " ("))) << condition;
  EXPECT_LE(largestLeft(grade), 1.2e-14) << condition;  // measured 2.2e-15
}

Quaterniond scalarLast(const Quaterniond& q) { return {q.x(), q.y(), q.z(), q.w()}; }

}  // namespace poinsot::reference
