// SPDX-License-Identifier: Apache-2.0
#include "reference/grade_reading.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace poinsot::reference {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using physics::Quaternion;

constexpr double kExact = 1e-10;  // smaller misfits differ only by rounding

class MeanSquare {
 public:
  void add(double error) {
    sum_ += error * error;
    ++count_;
  }
  std::optional<double> root() const {
    return count_ == 0 ? std::nullopt : std::optional(std::sqrt(sum_ / static_cast<double>(count_)));
  }

 private:
  double sum_ = 0;
  std::size_t count_ = 0;
};

Hypothesis hypothesis(std::function<bool(const LoggedState&)> applies, Reading reading) {
  return {reading.aspect, [applies = std::move(applies), reading = std::move(reading)](const LogSample& sample) {
            return applies(sample.theirs.front()) ? std::optional(reading) : std::nullopt;
          }};
}

bool hasOmega(const LoggedState& s) { return s.omega_B || s.omega_W; }

Hypothesis scaledOmega(const std::string& unit, double unit_radPerS) {
  return hypothesis(
      hasOmega,
      {Aspect::kUnit, {"omega is in " + unit, "its columns must be in rad/s"}, [unit_radPerS](LoggedState s) {
         for (auto* omega : {&s.omega_B, &s.omega_W})
           if (*omega) **omega *= unit_radPerS;
         return s;
       }});
}

Hypothesis scaledTime(const std::string& unit, double perSecond) {
  return hypothesis(
      [](const LoggedState&) { return true; },
      {Aspect::kTimeUnit, {"t is in " + unit, "its column must be in s"}, [perSecond](LoggedState s) {
         s.t_s /= perSecond;
         return s;
       }});
}

/// Solves omega + alpha (I omega) × omega = rate for omega in rad/s, by Newton's method from omega = rate.
Vector3d omegaTurningAt(const Vector3d& rate, const Matrix3d& I, double alpha) {
  const auto crossing = [](const Vector3d& v) {
    Matrix3d m;
    m << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
    return m;
  };
  Vector3d omega = rate;
  for (int i = 0; i < 30; ++i) {
    const Vector3d m = I * omega, off = omega + alpha * m.cross(omega) - rate;
    const Matrix3d slope = Matrix3d::Identity() + alpha * (crossing(m) - crossing(omega) * I);
    omega -= slope.partialPivLu().solve(off);
    if (off.norm() <= 1e-16 * rate.norm()) break;
  }
  return omega;
}

Hypothesis turningRate(const physics::Motion& motion) {
  const auto fromRate = [I = motion.axes().inertia_B(), alpha = motion.dissipation()](LoggedState s) {
    if (s.omega_B) s.omega_B = omegaTurningAt(*s.omega_B, I, alpha);
    if (s.omega_W) s.omega_W = *s.q_WB * omegaTurningAt(s.q_WB->conjugate() * *s.omega_W, I, alpha);
    return s;
  };
  const bool dissipates = motion.dissipation() > 0;
  return hypothesis(
      [dissipates](const LoggedState& s) { return dissipates && hasOmega(s) && (s.q_WB || !s.omega_W); },
      {Aspect::kRate,
       {"omega is the rate at which the attitude turns",
        "with dissipation that is omega + alpha L x omega, in the columns rate_B and rate_W"},
       fromRate});
}

}  // namespace

double largestOmega(const LogSample& sample) {
  double largest = 0;
  for (const physics::RigidBodyState& ours : sample.ours) largest = std::max(largest, ours.omega_B.norm());
  return largest;
}

Misfit misfitOf(const LogSample& sample) {
  const double scale = largestOmega(sample);
  MeanSquare attitude, omega;
  for (std::size_t i = 0; i < sample.ours.size(); ++i) {
    const LoggedState& theirs = sample.theirs[i];
    const physics::RigidBodyState& ours = sample.ours[i];
    if (theirs.q_WB) attitude.add(angleBetween(ours.q_WB, *theirs.q_WB));
    if (theirs.omega_B && scale > 0) omega.add((*theirs.omega_B - ours.omega_B).norm() / scale);
    if (theirs.omega_W && scale > 0) omega.add((*theirs.omega_W - ours.omega_W).norm() / scale);
  }
  return {attitude.root(), omega.root()};
}

double scoreOf(const Misfit& misfit) {
  double score = 0;
  for (const auto& value : {misfit.attitude, misfit.omega})
    if (value) score += std::log(std::max(*value, kExact));
  return score;
}

double scoreOf(const LogSample& sample) { return scoreOf(misfitOf(sample)); }

LoggedState readAs(LoggedState state, const std::vector<Reading>& readings) {
  for (const Reading& reading : readings) state = reading.apply(std::move(state));
  return state;
}

std::optional<LogSample> readAs(const LogSample& asWritten, const std::vector<Reading>& readings,
                                const KnownMotion& motion) {
  LogSample sample;
  for (std::size_t i = 0; i < asWritten.theirs.size(); ++i) {
    sample.theirs.push_back(readAs(asWritten.theirs[i], readings));
    const double t_s = sample.theirs.back().t_s;
    const bool sameTime = t_s == asWritten.theirs[i].t_s;
    if (!sameTime && !motion.knows(t_s)) return std::nullopt;
    sample.ours.push_back(sameTime ? asWritten.ours[i] : motion.at(t_s));
  }
  return sample;
}

std::vector<Hypothesis> namedHypotheses(const physics::Motion& motion) {
  return {
      hypothesis(hasAttitude, {Aspect::kOrder,
                               {"q_w, q_x, q_y, q_z hold x, y, z, w", "name the columns q_x, q_y, q_z, q_w"},
                               [](LoggedState s) {
                                 s.q_WB = Quaternion(s.q_WB->z(), s.q_WB->w(), s.q_WB->x(), s.q_WB->y());
                                 return s;
                               }}),
      hypothesis(hasAttitude,
                 {Aspect::kSense,
                  {"q is conjugated", "poinsot's q takes components along the body's axes to those in space"},
                  [](LoggedState s) {
                    s.q_WB = s.q_WB->conjugate();
                    return s;
                  }}),
      scaledOmega("deg/s", EIGEN_PI / 180),
      scaledOmega("rpm", EIGEN_PI / 30),
      scaledOmega("rev/s", 2 * EIGEN_PI),
      hypothesis(hasOmega, {Aspect::kFrame,
                            {"omega is along the axes of the other frame",
                             "omega_B is along the body's axes, omega_W along those of space"},
                            [](LoggedState s) {
                              std::swap(s.omega_B, s.omega_W);
                              return s;
                            }}),
      turningRate(motion),
      scaledTime("ms", 1e3),
      scaledTime("us", 1e6),
      scaledTime("ns", 1e9),
  };
}

}  // namespace poinsot::reference
