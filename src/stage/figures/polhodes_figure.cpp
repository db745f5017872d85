// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/polhodes_figure.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

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
constexpr int kRings = 24;          // rings of the filled area, from its middle to the polhode
constexpr double kShell = 0.004;    // half the thickness of the filled area, relative to the sphere's radius
constexpr double kAreaShare = 0.5;  // share of the polhode's colour in the filled area
constexpr float kSmooth = 3;        // rad; the filled area has no sharp edges

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

/// Makes the shell of the filled area. Its points are (ring, place) on two spheres, inside and outside of the
/// momentum sphere. Ring 0 is the one point in the middle.
class AreaShell {
 public:
  /// @param curve_P  closed curve on the sphere, around `middle_P`
  AreaShell(const std::vector<Vector3d>& curve_P, const Vector3d& middle_P) {
    const bool isLeft = middle_P.dot(curve_P[0].cross(curve_P[1])) > 0;
    const auto count = static_cast<std::uint32_t>(curve_P.size());
    for (const double radius : {1 + kShell, 1 - kShell}) addSheet(curve_P, middle_P, radius);
    const auto inside = static_cast<std::uint32_t>(mesh_.vertices_M.size() / 2);
    for (std::uint32_t j = 0; j < count; ++j) {
      const std::uint32_t here = isLeft ? j : (j + 1) % count, next = isLeft ? (j + 1) % count : j;
      for (const bool outer : {true, false}) addStrip(here, next, count, outer ? 0 : inside, outer);
      const std::uint32_t rim = 1 + (kRings - 1) * count;
      addQuad(rim + here, inside + rim + here, inside + rim + next, rim + next);
    }
  }

  std::shared_ptr<const draw::TriangleMesh> mesh() const { return std::make_shared<draw::TriangleMesh>(mesh_); }

 private:
  void addSheet(const std::vector<Vector3d>& curve_P, const Vector3d& middle_P, double radius) {
    mesh_.vertices_M.push_back(toPicture(Vector3d(radius * middle_P)));
    for (int ring = 1; ring <= kRings; ++ring)
      for (const Vector3d& p : curve_P)
        mesh_.vertices_M.push_back(toPicture(Vector3d(radius * between(middle_P, p, ring * (1.0 / kRings)))));
  }

  /// Returns a point of the great circle through two points of a sphere.
  static Vector3d between(const Vector3d& from, const Vector3d& to, double part) {
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(from, to);
    return Eigen::Quaterniond::Identity().slerp(part, turn) * from;
  }

  /// Adds the triangles between two neighbouring places, from the middle to the rim.
  void addStrip(std::uint32_t here, std::uint32_t next, std::uint32_t count, std::uint32_t first, bool outer) {
    if (!outer) std::swap(here, next);
    mesh_.triangles.push_back({first, first + 1 + here, first + 1 + next});
    for (std::uint32_t ring = 0; ring + 1 < kRings; ++ring) {
      const std::uint32_t nearer = first + 1 + ring * count, farther = nearer + count;
      addQuad(nearer + here, farther + here, farther + next, nearer + next);
    }
  }

  void addQuad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh_.triangles.push_back({a, b, c});
    mesh_.triangles.push_back({a, c, d});
  }

  draw::TriangleMesh mesh_;
};

/// Returns the tip of the half axis that a polhode of the given regime circles, on the sphere of the given radius.
Vector3d circledTip(const physics::PrincipalMoments& moments, physics::PolhodeRegime regime,
                    const Vector3d& on_P) {
  const auto axis = moments.ascendingAxes();
  const int circled = regime == physics::PolhodeRegime::kAboutLargest ? axis[2] : axis[0];
  return std::copysign(on_P.norm(), on_P[circled]) * Vector3d::Unit(circled);
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
  if (setting.scene.show.figures.binet.area) fillArea(moments, polhode.regime());
}

void BinetFigure::fillArea(const physics::PrincipalMoments& moments, physics::PolhodeRegime regime) {
  if (polhode_P_.size() < 3 || !closes_)
    throw core::sceneError(
        "show.binet.area: the polhode encloses no area, because L stands still in the body or is on the "
        "separatrix; "
        "leave it out");
  area_P_ = AreaShell(polhode_P_, circledTip(moments, regime, polhode_P_[0])).mesh();
}

void BinetFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  constexpr GlassShares kShares{.near = 0.7, .far = 1, .rim = 3.5};
  canvas.glassEllipsoid(radius_ * state.R_VP, canvas.colors.plane, opacity_, kShares);
  canvas.glassEllipsoid(state.R_VP * semiAxes_P_.asDiagonal(), canvas.colors.ellipsoid, opacity_, kShares);
  addFamily(canvas, state, curves_, canvas.colors.L);
  if (area_P_)
    canvas.list.meshes.push_back({area_P_,
                                  glm::vec3(0),
                                  toPicture(state.R_VP),
                                  kSmooth,
                                  {mixed(canvas.colors.polhode, canvas.colors.paper, kAreaShare), 0.1f}});
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
