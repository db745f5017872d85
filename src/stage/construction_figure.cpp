// SPDX-License-Identifier: Apache-2.0
#include "stage/construction_figure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/polhode.h"
#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kPlaneBeyondEllipsoid = 1.18;  // half width of the plane, in the ellipsoid's longest semi-axis
constexpr double kCellsToEdge = 7;              // about that many grid cells from the centre to the edge
constexpr double kRim = 3.8;                    // sheets' worth of glass at the rim
constexpr int kPolhodePoints = 400;
constexpr double kRecent_s = 0.9;  // film time of the bright end of the herpolhode

// Half of the directions to the faces, and to the corners, of a cube.
const Vector3d kDirections[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {-1, 1, 1}, {1, -1, 1}, {1, 1, -1}};

double niceNumber(double x) {
  const double power = std::pow(10.0, std::floor(std::log10(x)));
  for (const double step : {1.0, 2.0, 5.0})
    if (x <= 1.42 * step * power) return step * power;
  return 10 * power;
}

std::vector<Vector3d> pointsOf(const physics::Polhode& polhode) {
  std::vector<Vector3d> points;
  for (const auto& sample : polhode.samples(kPolhodePoints)) points.push_back(sample.omega_P);
  return points;
}

// Across L at the start, so that the grid holds still while L moves, and horizontal where L is upright.
Vector3d gridHint(const Vector3d& L_W) {
  return std::abs(L_W.normalized().x()) < 0.9 ? Vector3d(1, 0, 0) : Vector3d(0, 1, 0);
}

}  // namespace

ConstructionFigure::ConstructionFigure(const scene::Scene& scene, const PictureMotion& motion,
                                       const Scales& scales)
    : show_(scene.show),
      motion_(motion),
      scale_(scales.ellipsoid),
      polhodePeriod_s_(std::numeric_limits<double>::infinity()),
      gridHint_W_(gridHint(motion.liveliest().L_W)) {
  const Vector3d omega_P = motion.liveliest().omega_P;
  semiAxes_ = scale_ * physics::PoinsotConstruction(motion.moments(), omega_P).semiAxes_P();
  double radius = 0;
  for (const PathPoint& p : motion.outline())
    if (p.L_W.norm() > 0) radius = std::max(radius, p.L_W.normalized().cross(p.omega_W).norm());
  const double wanted = std::max(kPlaneBeyondEllipsoid * semiAxes_.maxCoeff(), 1.2 * scale_ * radius) / scale_;
  spacing_ = niceNumber(wanted / kCellsToEdge);
  halfWidth_ = std::ceil(wanted / spacing_ - 1e-9) * spacing_ * scale_;
  if (!motion.isFree()) return;
  const physics::Polhode polhode(motion.moments(), omega_P);
  polhode_P_ = pointsOf(polhode);
  polhodePeriod_s_ = polhode.period() / std::max(std::abs(motion.speed()), std::numeric_limits<double>::min());
}

physics::PoinsotConstruction ConstructionFigure::constructionAt(const PictureState& state) const {
  return {motion_.moments(), state.omega_P};
}

double ConstructionFigure::planeHeight(const PictureState& state) const {
  return scale_ * constructionAt(state).planeHeight();
}

// The plane belongs to inertial space: its grid turns with W where the body stands still.
Eigen::Matrix<double, 3, 2> ConstructionFigure::planeAxes_W(const Vector3d& normal_W) const {
  Eigen::Matrix<double, 3, 2> axes;
  axes.col(0) = (gridHint_W_ - gridHint_W_.dot(normal_W) * normal_W).normalized();
  axes.col(1) = normal_W.cross(axes.col(0));
  return axes;
}

std::array<Vector3d, 4> ConstructionFigure::planeCorners(const PictureState& state) const {
  const Vector3d down = state.L_W.normalized();
  const Eigen::Matrix<double, 3, 2> axes_W = planeAxes_W(down);
  const double height = planeHeight(state);
  const auto corner = [&](double a, double b) {
    return Vector3d(state.R_VW * (height * down + halfWidth_ * (a * axes_W.col(0) + b * axes_W.col(1))));
  };
  return {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
}

std::vector<Vector3d> ConstructionFigure::outermostPoints() const {
  std::vector<Vector3d> points;
  if (show_.polhode.visible || show_.herpolhode.visible)
    for (const PathPoint& p : motion_.outline())
      points.push_back(scale_ * (motion_.R_VW(p.filmTime_s) * p.omega_W));
  // Plane and ellipsoid as they move: corners and extremes, over the whole film.
  constexpr int kInstants = 48;
  for (int i = 0; i <= kInstants; ++i) {
    const PictureState state = motion_.at(motion_.duration_s() * i / kInstants);
    if (state.atRest()) continue;
    if (show_.plane.visible)
      for (const Vector3d& corner : planeCorners(state)) points.push_back(corner);
    const Matrix3d A = state.R_VP * (scale_ * constructionAt(state).semiAxes_P()).asDiagonal();
    for (const Vector3d& direction : kDirections) {
      if (!show_.ellipsoid.visible) break;
      const Vector3d extreme = A * (A.transpose() * direction).normalized();
      points.push_back(extreme);
      points.push_back(-extreme);
    }
  }
  return points;
}

void ConstructionFigure::addEllipsoid(draw::DrawList& list, const PictureState& state, const Palette& colors,
                                      double width_px) const {
  draw::GlassEllipsoid glass;
  // The graticule's poles are the ends of the longest axis, where lines may crowd most naturally.
  int longest = 0;
  semiAxes_.maxCoeff(&longest);
  const Matrix3d axes = state.R_VP * (scale_ * constructionAt(state).semiAxes_P()).asDiagonal();
  Matrix3d polar;
  polar << axes.col((longest + 1) % 3), axes.col((longest + 2) % 3), axes.col(longest);
  glass.semiAxes_W = toPicture(polar);
  glass.color = colors.ellipsoid;
  // Thinner on dark paper and on the near sheet, but 1 is opaque everywhere: powers of what passes.
  const auto sheet = [&](double share) {
    return static_cast<float>(1 - std::pow(1 - show_.ellipsoid.opacity, share * colors.sheetOpacity));
  };
  glass.nearOpacity = sheet(0.5);
  glass.farOpacity = sheet(1.2);
  glass.rimOpacity = sheet(kRim);
  if (show_.ellipsoid.graticule)
    glass.graticule = draw::Graticule{colors.graticule, static_cast<float>(0.8 * width_px), 0.75f, 0.3f};
  list.glassEllipsoids.push_back(glass);
}

void ConstructionFigure::addPlane(draw::DrawList& list, const PictureState& state, const Palette& colors,
                                  double width_px) const {
  const Vector3d normal = state.L_V.normalized();
  const Eigen::Matrix<double, 3, 2> axes_W = planeAxes_W(state.L_W.normalized());
  draw::GridPlane plane;
  plane.centre_W = toPicture(Vector3d(planeHeight(state) * normal));
  plane.u_W = toPicture(Vector3d(halfWidth_ * (state.R_VW * axes_W.col(0))));
  plane.v_W = toPicture(Vector3d(halfWidth_ * (state.R_VW * axes_W.col(1))));
  plane.spacing_W = static_cast<float>(spacing_ * scale_);
  plane.color = colors.plane;
  plane.opacity = static_cast<float>(1 - std::pow(1 - show_.plane.opacity, colors.sheetOpacity));
  plane.lineColor = colors.planeLine;
  plane.lineOpacity = show_.plane.grid ? 0.5f : 0.0f;
  plane.lineWidth_px = static_cast<float>(0.8 * width_px);
  if (show_.ellipsoid.visible) {
    plane.shadowCentre_W = toPicture(Vector3d(scale_ * state.omega_V));
    plane.shadowRadius_W = static_cast<float>(0.3 * semiAxes_.minCoeff());
    plane.shadowOpacity = 0.22f;
  }
  list.planes.push_back(plane);
}

draw::Curve ConstructionFigure::curveOn(const Matrix3d& axes_V, const std::vector<Vector3d>& points) const {
  draw::Curve curve;
  for (const Vector3d& p : points) curve.points_W.push_back(toPicture(Vector3d(scale_ * (axes_V * p))));
  return curve;
}

// The whole closed curve, faint, and over it what was travelled in the last period. Where something acts, the
// curve is the one that the motion would follow from now on if nothing did, and all that was travelled is shown.
void ConstructionFigure::addPolhode(draw::DrawList& list, double filmTime_s, const PictureState& state,
                                    const Palette& colors) const {
  draw::Curve whole;
  if (motion_.isFree()) {
    whole = curveOn(state.R_VP, polhode_P_);
    whole.closed = std::isfinite(polhodePeriod_s_);
  } else {
    const physics::Polhode polhode(motion_.moments(), state.omega_P);
    whole = curveOn(state.R_VP, pointsOf(polhode));
    whole.closed = std::isfinite(polhode.period());
  }
  whole.radius_W = 0.007f;
  whole.material.color = colors.futureTrail;
  list.curves.push_back(std::move(whole));

  const double span = std::min({filmTime_s, polhodePeriod_s_, motion_.longestPath_s()});
  std::vector<Vector3d> points;
  for (const PathPoint& p : motion_.path(filmTime_s - span, filmTime_s)) points.push_back(p.omega_P);
  draw::Curve travelled = curveOn(state.R_VP, points);
  travelled.radius_W = 0.011f;
  travelled.material.color = colors.trail;
  list.curves.push_back(std::move(travelled));
}

// What was travelled, its last second strong; what is to come, faint. In a film of very many turns, the nearest
// ones.
void ConstructionFigure::addHerpolhode(draw::DrawList& list, double filmTime_s, const Palette& colors,
                                       double width_px) const {
  const Matrix3d R_VW = motion_.R_VW(filmTime_s);
  const double longest = motion_.longestPath_s();
  const auto add = [&](double from_s, double to_s, const draw::Color& color, double width, float lift) {
    std::vector<Vector3d> points;
    for (const PathPoint& p : motion_.path(from_s, to_s)) points.push_back(p.omega_W);
    draw::Curve curve = curveOn(R_VW, points);
    curve.material.color = color;
    curve.width_px = static_cast<float>(width * width_px);
    curve.lift_W = lift;
    list.curves.push_back(std::move(curve));
  };
  const double end = std::min(motion_.duration_s(), filmTime_s + longest);
  const double recent = std::max(0.0, filmTime_s - std::min(kRecent_s, longest));
  if (show_.herpolhode.future && end > filmTime_s) add(filmTime_s, end, colors.futureTrail, 1.2, 0.004f);
  if (recent > 0) add(std::max(0.0, recent - longest), recent, colors.trail, 1.7, 0.008f);
  if (filmTime_s > 0) add(recent, filmTime_s, colors.trail, 2.9, 0.012f);
}

void ConstructionFigure::add(draw::DrawList& list, double filmTime_s, const PictureState& state,
                             const Palette& colors, double lineWidth_px) const {
  if (show_.herpolhode.visible) addHerpolhode(list, filmTime_s, colors, lineWidth_px);
  if (state.atRest()) return;
  if (show_.ellipsoid.visible) addEllipsoid(list, state, colors, lineWidth_px);
  if (show_.plane.visible) addPlane(list, state, colors, lineWidth_px);
  if (show_.polhode.visible) addPolhode(list, filmTime_s, state, colors);
  if (show_.contact.visible && (show_.plane.visible || show_.ellipsoid.visible)) {
    const double radius = 0.03 * show_.contact.scale;
    list.ellipsoids.push_back(
        {toPicture(Vector3d(scale_ * state.omega_V)), glm::mat3(static_cast<float>(radius)), {colors.ink, 0.4f}});
  }
}

}  // namespace poinsot::stage
