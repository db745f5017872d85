// SPDX-License-Identifier: Apache-2.0
#include <iterator>

#include "core/error.h"
#include "fuzz/input.h"
#include "reference/grade.h"

using namespace poinsot;

namespace {

constexpr std::size_t kMostRows = 100;  // a search reads all rows a few hundred times
constexpr double kMostSteps = 200;

struct Body {
  Eigen::Vector3d moments, omega;
};

/// Bodies: at rest, sphere, symmetric, asymmetric, near the separatrix, steady, needle.
const Body kBodies[] = {{{2, 2, 2}, {0, 0, 0}},         {{2, 2, 2}, {1, 2, 3}},     {{1, 1, 2}, {0.1, 0.2, 3}},
                        {{1, 2, 3}, {0.5, 0.1, 2}},     {{1, 2, 3}, {1e-12, 1, 0}}, {{1, 2, 3}, {0, 0, -2}},
                        {{1e-8, 1, 1}, {1, 1e-3, 2e-3}}};

/// Returns no forcing, isotropic drag, a torque or dissipation for kinds 0 to 3.
physics::Forcing forcingOf(unsigned kind) {
  physics::Forcing forcing;
  if (kind == 1) forcing.dragRate_P.setConstant(0.5);
  if (kind == 2) forcing.torque_B = {0.1, 0.2, 0.3};
  if (kind == 3) forcing.dissipation = 0.01;
  return forcing;
}

}  // namespace

// The input is a byte that selects the motion, then a table that is graded against it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const Body& body = kBodies[data[0] % std::size(kBodies)];
  const unsigned driven = data[0] / static_cast<unsigned>(std::size(kBodies)) % 4;
  const reference::MotionMaker maker = [&](const physics::TimeSpan& span) {
    return std::make_unique<physics::DrivenMotion>(physics::PrincipalMoments(body.moments), body.omega,
                                                   Eigen::Quaterniond(1, 2, 3, 4), forcingOf(driven), span, 1e-6,
                                                   kMostSteps);
  };
  try {
    const reference::TrajectoryTable theirs =
        reference::parseTrajectoryTable(fuzz::textOf({data + 1, size - 1}), "theirs.csv");
    if (theirs.rows() > kMostRows) return 0;
    // The search for a late start evaluates ten thousand times, so it runs only with motions in closed form.
    reference::grade(*maker(reference::spanOf(theirs)), theirs, driven < 2 ? maker : reference::MotionMaker());
  } catch (const core::Error& error) {
    fuzz::expectPrintable(error.what());
  }
  return 0;
}
