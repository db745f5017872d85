// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <utility>

#include "compare/change_measures.h"
#include "compare/changes.h"
#include "compare/difference.h"
#include "geometry/mesh_integrals.h"
#include "geometry/primitives.h"
#include "physics/binet.h"
#include "physics/driven_motion.h"
#include "physics/free_motion.h"
#include "physics/heavy_top.h"
#include "physics/herpolhode.h"
#include "physics/mass_properties.h"
#include "physics/particle_system.h"
#include "physics/polhode.h"
#include "physics/stability.h"
#include "physics/start.h"
#include "preconditions/breaches.h"
#include "scene/body_matrix.h"
#include "scene/document/problem.h"
#include "scene/motion/film_clock.h"
#include "scene/state_quantity.h"
#include "scene/units.h"

namespace poinsot {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using geometry::Vector2;
using physics::PrincipalMoments;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
const PrincipalMoments kMoments(1, 2, 2.5);

/// Evaluates a motion that was moved from.
template <typename Motion>
void askMovedFrom(Motion motion) {
  const Motion taken = std::move(motion);
  motion.at(0.0);  // NOLINT(bugprone-use-after-move): the breach
}

physics::FreeMotion freeMotion() { return {kMoments, {0.05, 2, 0.1}, Quaterniond::Identity()}; }

std::vector<Breach> ofPhysics() {
  const physics::ParticleSystem particles({{1, {0, 0, 0}, {0, 0, 0}}});
  const physics::Separatrix separatrix = *physics::separatrix(kMoments);
  return {
      {"physics/binet.h", "count >= 3", [=] { separatrix.momentumCircle(1, 2, false); }},
      {"physics/binet.h", "count >= 4", [] { physics::momentumPolhodes(kMoments, 1, 2, 3); }},
      {"physics/binet.h", "L > 0", [] { physics::evenEnergies(kMoments, 0, 1); }},
      {"physics/binet.h", "perSide >= 1", [] { physics::evenEnergies(kMoments, 1, 0); }},
      {"physics/binet.h", "T > 0",
       [] {
         physics::onEnergyEllipsoid({1, physics::PolhodeRegime::kSteady, {}}, kMoments, 0);
       }},
      {"physics/binet.h", "curve.kineticEnergy > 0", [] { physics::onEnergyEllipsoid({}, kMoments, 1); }},
      {"physics/driven_motion.h", "the motion was not moved from",
       [] {
         askMovedFrom(physics::DrivenMotion(kMoments, {0, 0, 1}, Quaterniond::Identity(), {}, {0, 1}));
       }},
      {"physics/free_motion.h", "the motion was not moved from", [] { askMovedFrom(freeMotion()); }},
      {"physics/heavy_top.h", "up_P is of unit length",
       [] {
         physics::heavyTop(PrincipalMoments(2, 2, 1), {0, 0, 3})->nutation({0, 0, 9}, {0, 0, 0});
       }},
      {"physics/heavy_top.h", "up_P is of unit length",
       [] {
         physics::heavyTop(PrincipalMoments(2, 2, 1), {0, 0, 3})->nutation({0, 0, 9}, {0, kNaN, 1});
       }},
      {"physics/heavy_top.h", "the rate is not 0",
       [] {
         physics::heavyTop(PrincipalMoments(2, 2, 1), {0, 0, 3})->spinOfPrecession(1, 0);
       }},
      {"physics/heavy_top.h", "the rate is not 0, wanted_s > 0",
       [] {
         physics::heavyTop(PrincipalMoments(2, 2, 1), {0, 0, 3})->nearestClosedPrecession(1, 0.5, 0);
       }},
      {"physics/herpolhode.h", "radius > 0",
       [] {
         physics::Herpolhode(kMoments, {0.05, 2, 0.1}).rate(0);
       }},
      {"physics/mass_properties.h", "at least one piece", [] { physics::combined({}); }},
      {"physics/motion.h", "the motion was not moved from",
       [] {
         physics::FreeMotion motion = freeMotion();
         const physics::FreeMotion taken = std::move(motion);
         const physics::Motion& asked = motion;  // NOLINT(bugprone-use-after-move): the breach
         asked.at(0.0);
       }},
      {"physics/particle_system.h", "one force for each",
       [=] {
         particles.torqueAbout({0, 0, 0}, {});
       }},
      {"physics/polhode.h", "count >= 4",
       [] {
         physics::Polhode(kMoments, {0.05, 2, 0.1}).samples(3);
       }},
      {"physics/principal_moments.h", "axis is 0, 1 or 2", [] { static_cast<void>(kMoments[3]); }},
      {"physics/principal_moments.h", "axis is 0, 1 or 2", [] { static_cast<void>(kMoments[-1]); }},
      {"physics/principal_axes.h", "of unit length",
       [] { physics::PrincipalAxes(kMoments, Quaterniond(1, 1, 0, 0)); }},
      {"physics/stability.h", "axis is 0, 1 or 2", [] { physics::spinStability(kMoments, 3, 1); }},
      {"physics/stability.h", "omega_P is along a principal axis",
       [] {
         physics::spinStability(kMoments, {0, 1, 1e-9});
       }},
      {"physics/stability.h", "the three moments are not all equal",
       [] {
         physics::flipInterval(PrincipalMoments(1, 1, 1), {0, 0, 1});
       }},
      {"physics/stability.h", "m_P is not 0",
       [] {
         physics::flipInterval(kMoments, {0, 0, 0});
       }},
      {"physics/start.h", "q_WB is not 0",
       [] {
         physics::omegaFromSpace(Quaterniond(0, 0, 0, 0), {0, 0, 1});
       }},
      {"physics/start.h", "q_WB is not 0",
       [] {
         physics::omegaFromMomentum(kMoments, Quaterniond(0, 0, 0, 0), {0, 0, 1});
       }},
  };
}

geometry::Mesh triangle(double x, std::uint32_t last) {
  return {{{x, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, last}}};
}

std::vector<Breach> ofGeometry() {
  using namespace geometry;
  const Mesh whole = triangle(0, 2), beyond = triangle(0, 3), notANumber = triangle(kNaN, 2);
  const std::vector<Vector2> bent = {{0, 0}, {2, 0}, {2, 2}, {1.5, 0.5}, {0, 2}};
  return {
      {"geometry/mesh.h", "at least one vertex", [] { boundsOf({}); }},
      {"geometry/mesh.h", "det A > 0", [=] { transformed(whole, -Matrix3d::Identity()); }},
      {"geometry/mesh.h", "det A > 0", [=] { transformed(whole, Matrix3d::Zero()); }},
      {"geometry/mesh.h", "finite", [=] { welded(notANumber); }},
      {"geometry/mesh.h", "indices in range", [=] { welded(beyond); }},
      {"geometry/mesh.h", "as many targets as vertices",
       [=] {
         merged(whole, {0, 1});
       }},
      {"geometry/mesh.h", "target[target[i]] == target[i]",
       [=] {
         merged(whole, {1, 2, 2});
       }},
      {"geometry/mesh.h", "target[target[i]] == target[i]",
       [=] {
         merged(whole, {0, 1, 9});
       }},
      {"geometry/mesh_integrals.h", "at least one vertex", [] { integrals({}); }},
      {"geometry/mesh_integrals.h", "indices in range", [=] { integrals(beyond); }},
      {"geometry/mesh_integrals.h", "coordinates finite", [=] { integrals(notANumber); }},
      {"geometry/mesh_integrals.h", "indices in range", [=] { checkClosed(beyond); }},
      {"geometry/mesh_integrals.h", "coordinates finite", [=] { checkClosed(notANumber); }},
      {"geometry/primitives.h", "segments >= 3",
       [] {
         turnedMesh(std::vector<Vector2>{{0, 0}, {1, 0}, {0, 1}}, 2);
       }},
      {"geometry/primitives.h", "three corners or more",
       [] {
         turnedMesh(std::vector<Vector2>{{0, 0}, {1, 0}}, 9);
       }},
      {"geometry/primitives.h", "none with r < 0",
       [] {
         turnedMesh(std::vector<Vector2>{{0, 0}, {-1, 0}, {0, 1}}, 9);
       }},
      {"geometry/primitives.h", "three corners or more",
       [] {
         prismMesh(std::vector<Vector2>{{0, 0}, {1, 0}}, 1);
       }},
      {"geometry/primitives.h", "the first one sees every other", [=] { prismMesh(bent, 1); }},
      {"geometry/primitives.h", "subdivisions <= 8",
       [] {
         ellipsoidMesh({1, 1, 1}, 9);
       }},
      {"geometry/primitives.h", "tubeRadius_m < radius_m", [] { torusMesh(1, 1, 9); }},
      {"geometry/primitives.h", "low_m < high_m", [] { frustumMesh(1, 1, 0, 0, 9); }},
      {"geometry/primitives.h", "not both radii 0", [] { frustumMesh(0, 0, 0, 1, 9); }},
      {"geometry/primitives.h", "innerRadius_m < radius_m", [] { tubeMesh(1, 1, 1, 9); }},
      {"geometry/primitives.h", "arm_m < both edges",
       [] {
         lPrismMesh({1, 1}, 1, 1);
       }},
  };
}

std::vector<Breach> ofScene() {
  using namespace scene;
  const int beyond = static_cast<int>(stateQuantities().size());
  return {
      {"scene/motion/eased_track.h", "no turn before this one",
       [] {
         EasedTrack track(1);
         track.turnTo(2, 0, 1);
         track.turnTo(1, 0, 1);
       }},
      {"scene/motion/eased_track.h", "at_s >= 0", [] { EasedTrack(1).turnTo(-1, 0, 1); }},
      {"scene/motion/eased_track.h", "over_s >= 0", [] { EasedTrack(1).turnTo(0, -1, 1); }},
      {"scene/motion/film_clock.h", "a finite time", [] { FilmClock(0, 1, {}).motionTime_s(INFINITY); }},
      {"scene/motion/film_clock.h", "a finite time", [] { FilmClock(0, 0, {}).played_s(kNaN); }},
      {"scene/motion/film_clock.h", "finite times, duration_s >= 0",
       [] { FilmClock(0, 1, {}).filmTimesOf(kNaN, 1); }},
      {"scene/motion/film_clock.h", "not NaN", [] { FilmClock(0, 1, {}).pace(kNaN); }},
      {"scene/body_matrix.h", "lackFor(body, matrix) is empty", [] { bodyMatrix(Body(), BodyMatrix::kUOwn); }},
      {"scene/document/problem.h", "at least one problem", [] { SceneErrors({}); }},
      {"scene/state_quantity.h", "index of a quantity", [] { stateQuantity(-1); }},
      {"scene/state_quantity.h", "index of a quantity", [=] { quantityTex(beyond, {}); }},
      {"scene/units.h", "has this dimension", [] { unitFactor("kg", Dimension::kAngle); }},
      {"scene/units.h", "the unit exists", [] { unitFactor("furlong", Dimension::kLength); }},
  };
}

std::vector<Breach> ofImage() {
  using namespace compare;
  using namespace image;
  const Image small({4, 4}, 3), large({5, 4}, 3), withAlpha({4, 4}, 4);
  const DeepImage deep({4, 4}, 3);
  return {
      {"image/image.h", "width, height > 0",
       [] {
         Image({0, 4}, 3);
       }},
      {"image/image.h", "channels 3 or 4",
       [] {
         Image({4, 4}, 2);
       }},
      {"image/image.h", "inside the picture", [=] { small.at(0, 10); }},
      {"image/image.h", "inside the picture", [=] { small.at(4, 0); }},
      {"image/image.h", "inside the picture", [=] { deep.at(-1, 1); }},
      {"compare/change_measures.h", "the same shape", [=] { symmetryOf(small, large); }},
      {"compare/change_measures.h", "and differ", [=] { symmetryOf(small, small); }},
      {"compare/change_measures.h", "the same shape", [=] { toneChange(small, withAlpha, nullptr); }},
      {"compare/changes.h", "the same size", [=] { changesBetween(small, large); }},
      {"compare/changes.h", "number of channels", [=] { changesBetween(small, withAlpha); }},
      {"compare/difference.h", "the same sample type", [=] { compareCommon(small, deep); }},
      {"compare/flip.h", "same size", [=] { flip(small, large); }},
      {"compare/flip.h", "pixelsPerDegree > 0", [=] { flip(small, small, 0); }},
      {"compare/ignore_mask.h", "width, height > 0",
       [] {
         IgnoreMask({4, 0});
       }},
      {"compare/ignore_mask.h", "same size",
       [=] {
         IgnoreMask({4, 4}).add(AnyImage(large));
       }},
      {"compare/ignore_mask.h", "inside the picture",
       [] {
         IgnoreMask({4, 4}).ignores(4, 0);
       }},
      {"compare/ignore_mask.h", "inside the picture",
       [] {
         IgnoreMask({4, 4}).ignores(1, -1);
       }},
      {"compare/ignore_mask.h", "inside the picture",
       [] {
         IgnoreMask({4, 4}).ignoresPixel(16);
       }},
      {"compare/ignore_mask.h", "of one size",
       [=] {
         withIgnoredOf(small, small, IgnoreMask({5, 4}));
       }},
      {"compare/ignore_mask.h", "number of channels",
       [=] {
         withIgnoredOf(small, withAlpha, IgnoreMask({4, 4}));
       }},
      {"compare/ignore_mask.h", "one sample type",
       [=] {
         withIgnoredOf(AnyImage(small), AnyImage(deep), IgnoreMask({4, 4}));
       }},
      {"compare/ssim.h", "same size", [=] { ssim(small, large); }},
  };
}

}  // namespace

std::vector<Breach> breachesOfValues() {
  std::vector<Breach> all;
  for (const auto& part : {ofPhysics(), ofGeometry(), ofScene(), ofImage()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace poinsot
