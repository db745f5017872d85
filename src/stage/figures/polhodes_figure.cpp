// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/polhodes_figure.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"
#include "physics/binet.h"
#include "physics/polhode.h"
#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int kPoints = 240;
constexpr double kPaleShare = 0.55;
constexpr double kTube = 0.012;

void requireFree(const PictureMotion& motion, const char* key) {
  if (motion.isFree()) return;
  throw core::sceneError(
      fmt::format("{}: polhodes are constant only if nothing acts on the body; leave them out", key));
}

/// Returns the polhodes with this L, as curves in momentum space; the separatrix is last.
std::vector<physics::MomentumPolhode> family(const physics::PrincipalMoments& moments, double L, int perSide) {
  std::vector<physics::MomentumPolhode> all;
  for (const double T : physics::evenEnergies(moments, L, perSide))
    for (physics::MomentumPolhode& curve : physics::momentumPolhodes(moments, T, L, kPoints))
      all.push_back(std::move(curve));
  if (const auto parting = physics::separatrix(moments)) {
    const double T = L * L / (2 * moments[parting->middle]);
    for (const bool mirrored : {false, true})
      all.push_back({T, physics::PolhodeRegime::kSeparatrix, parting->momentumCircle(L, kPoints, mirrored)});
  }
  return all;
}

std::vector<Vector3d> times(double scale, std::vector<Vector3d> points) {
  for (Vector3d& p : points) p *= scale;
  return points;
}

std::vector<Vector3d> turned(const Matrix3d& R_VP, const std::vector<Vector3d>& points_P) {
  std::vector<Vector3d> points;
  for (const Vector3d& p : points_P) points.emplace_back(R_VP * p);
  return points;
}

void addFamily(const Canvas& canvas, const PictureState& state, const std::vector<BodyCurve>& curves,
               const draw::Color& color) {
  for (const BodyCurve& curve : curves)
    canvas.line(turned(state.R_VP, curve.points_P), true,
                curve.separatrix ? canvas.colors.separatrix : mixed(color, canvas.colors.paper, kPaleShare),
                curve.separatrix ? 1.8 : 1, 0.012);
}

}  // namespace

PolhodesFigure::PolhodesFigure(const Setting& setting) {
  requireFree(setting.motion, "show.polhodes.visible");
  const physics::PrincipalMoments& moments = setting.motion.moments();
  const Vector3d omega_P = setting.motion.liveliest().omega_P, m_P = moments.angularMomentum(omega_P);
  const double T = 0.5 * omega_P.dot(m_P);
  for (const auto& curve : family(moments, m_P.norm(), setting.scene.show.figures.polhodes.count))
    curves_.push_back({times(setting.scales.ellipsoid, physics::onEnergyEllipsoid(curve, moments, T)),
                       curve.regime == physics::PolhodeRegime::kSeparatrix});
}

void PolhodesFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  addFamily(canvas, state, curves_, canvas.colors.polhode);
}

std::vector<Vector3d> PolhodesFigure::outermostPoints(const PictureState& state) const {
  std::vector<Vector3d> points;
  for (const BodyCurve& curve : curves_)
    for (std::size_t i = 0; i < curve.points_P.size(); i += 12)
      points.emplace_back(state.R_VP * curve.points_P[i]);
  return points;
}

BinetFigure::BinetFigure(const Setting& setting) : opacity_(setting.scene.show.figures.binet.opacity) {
  requireFree(setting.motion, "show.binet.visible");
  const physics::PrincipalMoments& moments = setting.motion.moments();
  const Vector3d omega_P = setting.motion.liveliest().omega_P;
  const physics::BinetConstruction construction(moments, omega_P);
  scale_ = setting.scales.L;  // the arrow of L ends on the sphere
  radius_ = scale_ * construction.sphereRadius();
  semiAxes_P_ = scale_ * construction.semiAxes_P();
  for (const auto& curve : family(moments, construction.sphereRadius(), setting.scene.show.figures.binet.count))
    curves_.push_back({times(scale_, curve.m_P), curve.regime == physics::PolhodeRegime::kSeparatrix});
  const physics::Polhode polhode(moments, omega_P);
  closes_ = std::isfinite(polhode.period());
  for (const auto& sample : polhode.samples(kPoints))
    polhode_P_.push_back(scale_ * moments.angularMomentum(sample.omega_P));
}

void BinetFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  constexpr GlassShares kShares{.near = 0.7, .far = 1, .rim = 3.5};
  canvas.glassEllipsoid(radius_ * state.R_VP, canvas.colors.plane, opacity_, kShares);
  canvas.glassEllipsoid(state.R_VP * semiAxes_P_.asDiagonal(), canvas.colors.ellipsoid, opacity_, kShares);
  addFamily(canvas, state, curves_, canvas.colors.L);
  canvas.tube(turned(state.R_VP, polhode_P_), closes_, kTube, canvas.colors.polhode);
  canvas.dot(scale_ * state.L_V, 0.034, canvas.colors.ink);
}

std::vector<Vector3d> BinetFigure::outermostPoints(const PictureState& state) const {
  std::vector<Vector3d> points;
  for (int i = 0; i < 3; ++i)
    for (const double side : {-1.0, 1.0}) {
      points.emplace_back(side * radius_ * Vector3d::Unit(i));
      points.emplace_back(side * semiAxes_P_[i] * state.R_VP.col(i));
    }
  return points;
}

}  // namespace poinsot::stage
