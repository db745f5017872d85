// SPDX-License-Identifier: Apache-2.0
// Prints a hash of every bit of a few trajectories, for the test that the CPU's features change none.
#include <cinttypes>
#include <cstdio>
#include <cstring>

#include "physics/free_motion.h"
#include "physics/herpolhode.h"
#include "physics/polhode.h"

using namespace poinsot::physics;

namespace {

class Hash {
 public:
  void add(double value) {  // FNV-1a
    unsigned char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    for (const unsigned char byte : bytes) value_ = (value_ ^ byte) * 0x100000001b3u;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

void addTrajectory(Hash& hash, const Eigen::Vector3d& I, const Eigen::Vector3d& omega0) {
  const PrincipalMoments moments(I);
  const FreeMotion motion(moments, omega0, Eigen::Quaterniond(0.5, -0.25, 0.75, 1.5));
  for (int k = -2000; k < 2000; ++k) {
    const RigidBodyState s = motion.at(k * 0.37 + k * 1e3);
    for (int i = 0; i < 4; ++i) hash.add(s.q_WB.coeffs()[i]);
    for (int i = 0; i < 3; ++i) hash.add(s.omega_B[i]), hash.add(s.omega_W[i]);
  }
  for (const PolhodeSample& sample : Polhode(moments, omega0).samples(100))
    hash.add(sample.t_s + sample.omega_P[0]);
  hash.add(Herpolhode(moments, omega0).anglePerRadialPeriod());
}

}  // namespace

int main() {
  Hash hash;
  addTrajectory(hash, {2, 3, 4}, {.5, .25, 1});
  addTrajectory(hash, {2, 3, 4}, {1, .25, .25});
  addTrajectory(hash, {1, 2, 2.25}, {.75, .5, 1});
  addTrajectory(hash, {3, 1, 2}, {.25, 1, -.5});
  addTrajectory(hash, {1.5, 1.5, .9}, {.5, 0, 2});
  addTrajectory(hash, {1, 2, 3}, {1e-9, 1, 0});
  addTrajectory(hash, {2, 3, 4}, {0, 0, 1.3});
  std::printf("%016" PRIx64 "\n", hash.value());
}
