// SPDX-License-Identifier: Apache-2.0
// Families of polhodes, Binet's construction and components, compared with the quadrics that they must lie on.
#include "stage/figures/polhodes_figure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "physics/geometric_phase.h"
#include "scene_samples.h"
#include "scenery.h"
#include "stage/figures/axes_figure.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

const Vector3d kI(1, 1.7, 2.6), kOmega(0.9, 0.35, 1.1);

Scenery scenery(const std::string& more = "") {
  return Scenery("[body]\nprincipal_moments = [1, 1.7, 2.6]\n[motion]\nomega_body = [0.9, 0.35, 1.1]\n" + more);
}

double twoT() { return kOmega.dot(kI.cwiseProduct(kOmega)); }

TEST(PolhodesFigure, EveryCurveIsOnTheEnergyEllipsoid) {
  const Scenery s = scenery();
  const PolhodesFigure figure(s.setting);
  ASSERT_EQ(figure.curves().size(), 2u * 4 * 2 + 2);  // both sides, both ends of an axis, and the separatrix
  int parting = 0;
  for (const BodyCurve& curve : figure.curves()) {
    parting += curve.separatrix;
    for (const Vector3d& p : curve.points_P) {
      const Vector3d omega = p / s.scales.ellipsoid, m = kI.cwiseProduct(omega);
      EXPECT_NEAR(omega.dot(m) / twoT(), 1, 1e-13);  // measured 1.1e-15
      // L² = 2 T I2 holds on the separatrix alone.
      const double excess = m.squaredNorm() / (twoT() * kI[1]) - 1;
      if (curve.separatrix) {
        EXPECT_NEAR(excess, 0, 1e-13);  // measured 4e-16
      } else {
        EXPECT_GT(std::abs(excess), 1e-3);
      }
    }
  }
  EXPECT_EQ(parting, 2);
}

TEST(BinetFigure, TheTipOfLIsOnBothSurfacesAndOnTheCurve) {
  const Scenery s = scenery();
  const BinetFigure figure(s.setting);
  const auto onSurfaces = [&](const Vector3d& p_P) {
    EXPECT_NEAR(p_P.norm(), figure.sphereRadius(), 1e-13);                 // measured 7e-16
    EXPECT_NEAR(p_P.cwiseQuotient(figure.semiAxes_P()).norm(), 1, 1e-13);  // measured 4.4e-16
  };
  for (const Vector3d& p_P : figure.polhode_P()) onSurfaces(p_P);
  for (const double t : {0.0, 2.3, 7.0}) {
    const PictureState state = s.motion.at(t);
    const Vector3d tip_P = s.scales.L * (state.R_VP.transpose() * state.L_V);
    onSurfaces(tip_P);
    double nearest = 1;
    for (const Vector3d& p_P : figure.polhode_P()) nearest = std::min(nearest, (p_P - tip_P).norm());
    EXPECT_LT(nearest, 0.03);  // half a step of the curve
  }
  for (const BodyCurve& curve : figure.curves())
    for (const Vector3d& p_P : curve.points_P) EXPECT_NEAR(p_P.norm(), figure.sphereRadius(), 1e-13);
}

/// Solid angle of a triangle of directions from the origin (van Oosterom & Strackee, IEEE Trans. Biomed. Eng. 30
/// (1983) 125).
double solidAngle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const double A = a.norm(), B = b.norm(), C = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)), A * B * C + a.dot(b) * C + b.dot(c) * A + c.dot(a) * B);
}

// The triangles of the outer sheet, seen from the centre, add up to the solid angle of the polhode; those of the
// inner sheet are turned inwards.
TEST(BinetFigure, FilledAreaHasTheSolidAngleOfThePolhode) {
  for (const char* omega : {"[0.9, 0.35, 1.1]", "[-1.5, 0.2, 0.3]", "[0.3, 0.1, -1.1]"}) {
    const Scenery s("[body]\nprincipal_moments = [1, 1.7, 2.6]\n[motion]\nomega_body = " + std::string(omega) +
                    "\n[show.binet]\nvisible = true\narea = true\n");
    const BinetFigure figure(s.setting);
    ASSERT_TRUE(figure.area_P());
    double outer = 0, sum = 0;
    for (const auto& triangle : figure.area_P()->triangles) {
      const auto at = [&](int i) {
        const glm::vec3& v = figure.area_P()->vertices_M[triangle[static_cast<std::size_t>(i)]];
        return Vector3d(v.x, v.y, v.z);
      };
      const double part = solidAngle(at(0), at(1), at(2));
      const bool isOuter = std::min({at(0).norm(), at(1).norm(), at(2).norm()}) > figure.sphereRadius();
      outer += isOuter ? part : 0;
      sum += part;
    }
    const Vector3d& omega_P = s.motion.liveliest().omega_P;
    const double expected = physics::geometricPhase(s.motion.moments(), omega_P)->solidAngle_sr;
    EXPECT_NEAR(outer / expected, 1, 1e-3);  // the polhode is a polygon here
    EXPECT_NEAR(sum, 0, 1e-4);               // a closed surface
  }
}

TEST(BinetFigure, FillsNoAreaOfASteadySpin) {
  const Scenery s(
      "[body]\nprincipal_moments = [1, 1.7, 2.6]\n[motion]\nomega_body = [0, 0, 1]\n"
      "[show.binet]\nvisible = true\narea = true\n");
  EXPECT_THROW(BinetFigure{s.setting}, core::Error);
}

TEST(PolhodesFigure, NeedsAFreeMotion) {
  const Scenery s = scenery("[motion.torque]\nbody = [0, 0, 1]\n");
  EXPECT_THROW(PolhodesFigure{s.setting}, core::Error);
  EXPECT_THROW(BinetFigure{s.setting}, core::Error);
}

TEST(ComponentsFigure, ComponentsSumToOmegaAndLieAlongTheirAxes) {
  for (const char* more : {"", "[camera]\nframe = \"body\"\n"}) {
    const Scenery s = scenery(more);
    const ComponentsFigure figure(s.setting);
    for (const double t : {0.0, 2.3, 7.0}) {
      const PictureState state = s.motion.at(t);
      const Eigen::Matrix3d parts = figure.components_V(state);
      EXPECT_LT((parts.rowwise().sum() - s.scales.omega * state.omega_V).norm(), 1e-14);  // measured 4e-16
      for (int i = 0; i < 3; ++i) EXPECT_LT(parts.col(i).cross(state.R_VP.col(i)).norm(), 1e-15);
    }
  }
}

}  // namespace
}  // namespace poinsot::stage
