// SPDX-License-Identifier: Apache-2.0
// Prints a hash of all bits of some trajectories and of the functions that they use. A test compares the hash
// between CPUs and compilers. With --libm, prints a hash of the C library's functions as a control, which changes
// if the library has code for the CPU's vector units.
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "physics/driven_motion.h"
#include "physics/free_motion.h"
#include "physics/herpolhode.h"
#include "physics/polhode.h"
#include "physics/transcendental.h"

using namespace poinsot::physics;

namespace {

class Hash {
 public:
  void add(double value) {  // FNV-1a
    unsigned char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    for (const unsigned char byte : bytes) value_ = (value_ ^ byte) * 0x100000001b3u;
  }
  void add(std::initializer_list<double> values) {
    for (const double value : values) add(value);
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

void addState(Hash& hash, const RigidBodyState& s) {
  for (int i = 0; i < 4; ++i) hash.add(s.q_WB.coeffs()[i]);
  for (int i = 0; i < 3; ++i) hash.add({s.omega_B[i], s.omega_W[i], s.L_W[i]});
  hash.add(s.kineticEnergy);
}

void addTrajectory(Hash& hash, const PrincipalAxes& axes, const Eigen::Vector3d& omega0_B) {
  const FreeMotion motion(axes, omega0_B, Eigen::Quaterniond(0.5, -0.25, 0.75, 1.5));
  for (int k = -2000; k < 2000; ++k) addState(hash, motion.at(k * 0.37 + k * 1e3));
}

void addCurves(Hash& hash, const PrincipalMoments& moments, const Eigen::Vector3d& omega0) {
  for (const PolhodeSample& sample : Polhode(moments, omega0).samples(100))
    hash.add(sample.t_s + sample.omega_P[0]);
  hash.add(Herpolhode(moments, omega0).anglePerRadialPeriod());
}

void addMotions(Hash& hash) {
  const struct {
    Eigen::Vector3d I, omega0;
  } starts[] = {
      {{2, 3, 4}, {.5, .25, 1}},          // about the largest axis
      {{2, 3, 4}, {1, .25, .25}},         // about the smallest axis
      {{1, 2, 2.25}, {.75, .5, 1}},       // separatrix
      {{3, 1, 2}, {.25, 1, -.5}},         // axes in another order
      {{1.5, 1.5, .9}, {.5, 0, 2}},       // symmetric
      {{1, 1 + 1e-12, 1.1}, {1, .5, 1}},  // nearly symmetric
      {{1e-9, 1, 1}, {1, .5, -.25}},      // a needle
      {{1, 2, 3}, {1e-9, 1, 0}},          // about the middle axis
      {{2, 3, 4}, {0, 0, 1.3}},           // steady
  };
  for (const auto& start : starts) {
    addTrajectory(hash, PrincipalMoments(start.I), start.omega0);
    addCurves(hash, PrincipalMoments(start.I), start.omega0);
  }
  Eigen::Matrix3d inertia_B;
  inertia_B << 8.5, -0.25, 1.0, -0.25, 8.625, 2.125, 1.0, 2.125, 9.25;
  addTrajectory(hash, PrincipalAxes(inertia_B), {0.6, -1.1, 0.8});
}

// Covers every kind of forcing, and both compositions among which the integrator chooses.
void addDrivenMotions(Hash& hash) {
  Forcing forcing;
  forcing.gravity_B = {0.3, 0.5, 1};
  forcing.torque_B = {0, 0.2, 0.1};
  forcing.torqueHistory_W = {{-1, 0.5, 2}, {{1, 0, 0}, {0, 1, 0.3}, {0.1, 0.2, 0.3}}, true};
  Eigen::Matrix3d inertia_B;
  inertia_B << 8.5, -0.25, 1.0, -0.25, 8.625, 2.125, 1.0, 2.125, 9.25;
  for (const Eigen::Vector3d& drag : {Eigen::Vector3d(0.1, 0.1, 0.1), Eigen::Vector3d(0.1, 0.2, 0.05)}) {
    forcing.dragRate_P = drag;
    const DrivenMotion motion(PrincipalAxes(inertia_B), {0.5, 1, 2}, Eigen::Quaterniond(0.5, -0.25, 0.75, 1.5),
                              forcing, {-3, 5});
    for (int k = -30; k <= 50; ++k) addState(hash, motion.at(k * 0.1));
    hash.add(motion.report().estimatedAttitudeError_rad);
    forcing.dissipation = 0.02;
  }
}

void addFunctions(Hash& hash) {
  for (int k = -20000; k <= 20000; ++k) {
    const double x = k * 0.00137 + k * 1e-9;
    const SineCosine angle = sineCosine(x);
    const HyperbolicPair h = hyperbolicPair(x);
    hash.add({angle.sine, angle.cosine, arcTangent(x), exponential(x), exponentialLessOne(x), h.tanh, h.sech,
              logarithm(x * x + 1e-9)});
  }
}

void addCLibrary(Hash& hash) {
  for (int k = -20000; k <= 20000; ++k) {
    const double x = k * 0.00137 + k * 1e-9;
    hash.add({std::sin(x), std::cos(x), std::tan(x), std::atan(x), std::exp(x), std::log(x * x + 1e-9),
              std::pow(x * x, 0.3)});
  }
}

}  // namespace

int main(int count, char** arguments) {
  Hash hash;
  if (count > 1 && std::strcmp(arguments[1], "--libm") == 0) {
    addCLibrary(hash);
  } else {
    addMotions(hash);
    addDrivenMotions(hash);
    addFunctions(hash);
  }
  std::printf("%016" PRIx64 "\n", hash.value());
}
