// SPDX-License-Identifier: Apache-2.0
#include "reference/grade_engines.h"

#include <fmt/format.h>

namespace poinsot::reference {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

Vector3d acceleration(const Vector3d& I, const Vector3d& w) { return I.cwiseProduct(w).cross(w).cwiseQuotient(I); }

Eigen::Vector4d rate(const Quaterniond& q, const Vector3d& w) {
  return (q * Quaterniond(0, w.x(), w.y(), w.z())).coeffs() / 2;
}

Quaterniond moved(const Quaterniond& q, const Eigen::Vector4d& by) { return Quaterniond(q.coeffs() + by); }

}  // namespace

EngineState explicitEuler(const Vector3d& I, const EngineState& s, double h) {
  return {moved(s.q_WB, h * rate(s.q_WB, s.omega_B)).normalized(), s.omega_B + h * acceleration(I, s.omega_B)};
}

EngineState semiImplicitEuler(const Vector3d& I, const EngineState& s, double h) {
  const Vector3d w = s.omega_B + h * acceleration(I, s.omega_B);
  return {moved(s.q_WB, h * rate(s.q_WB, w)).normalized(), w};
}

EngineState rungeKutta(const Vector3d& I, const EngineState& s, double h) {
  const Vector3d w1 = acceleration(I, s.omega_B), w2 = acceleration(I, s.omega_B + h / 2 * w1),
                 w3 = acceleration(I, s.omega_B + h / 2 * w2), w4 = acceleration(I, s.omega_B + h * w3);
  const Eigen::Vector4d q1 = rate(s.q_WB, s.omega_B), q2 = rate(moved(s.q_WB, h / 2 * q1), s.omega_B + h / 2 * w1),
                        q3 = rate(moved(s.q_WB, h / 2 * q2), s.omega_B + h / 2 * w2),
                        q4 = rate(moved(s.q_WB, h * q3), s.omega_B + h * w3);
  return {moved(s.q_WB, h / 6 * (q1 + 2 * q2 + 2 * q3 + q4)).normalized(),
          s.omega_B + h / 6 * (w1 + 2 * w2 + 2 * w3 + w4)};
}

std::string engineCsv(const EngineStep& step, const Vector3d& I, EngineState s, double h, int steps, int every,
                      int digits) {
  std::string csv = "t,q_w,q_x,q_y,q_z,omega_B_x,omega_B_y,omega_B_z\n";
  for (int k = 0; k <= steps; ++k, s = step(I, s, h)) {
    if (k % every != 0) continue;
    csv += fmt::format("{:.17g}", k * h);
    for (const double v :
         {s.q_WB.w(), s.q_WB.x(), s.q_WB.y(), s.q_WB.z(), s.omega_B.x(), s.omega_B.y(), s.omega_B.z()})
      csv += fmt::format(",{:.{}g}", v, digits);
    csv += '\n';
  }
  return csv;
}

}  // namespace poinsot::reference
