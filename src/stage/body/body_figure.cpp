// SPDX-License-Identifier: Apache-2.0
#include "stage/body/body_figure.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "physics/symmetric_eigen.h"
#include "stage/body/parts_figure.h"
#include "stage/body/round_sketch.h"

namespace poinsot::stage {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kThinnest = 0.07;  // smallest drawn half edge, as a fraction of the longest; used for a lamina
constexpr double kPoint = 1e-3;     // largest size of a point mass, relative to its distance from the fixed point

/// Returns the largest |A p| of all points p of a piece. |A p| is convex, so its maximum is at a support point.
/// From each start, the loop climbs to a local maximum: it replaces p by the support point in the direction Aᵀ A
/// p.
double farthest(const Piece& piece, const Matrix3d& A) {
  constexpr int kSteps = 40;  // largest number of steps; more steps would gain very little
  double most = 0;
  for (const Vector3d& start : cubeDirections()) {
    Vector3d direction = A.transpose() * start;
    double reached = 0;
    for (int i = 0; i < kSteps; ++i) {
      const Vector3d image = A * supportPoint(piece, direction);
      if (!(image.norm() > reached)) break;
      reached = image.norm();
      direction = A.transpose() * image;
    }
    most = std::max(most, reached);
  }
  return most;
}

Figure equivalentBoxFigure(const physics::PrincipalAxes& axes) {
  Figure figure;
  const Sketch sketch(figure, axes.q_BP().toRotationMatrix(), Vector3d::Zero());
  sketch.box(Vector3d::Zero(), equivalentBox(axes.moments()));
  return figure;
}

/// Returns the uniform box with this mass and inertia tensor, at the centre of mass and to scale. A box with half
/// edges h has I1 = M (h2² + h3²)/3.
Figure uniformBoxFigure(const physics::MassProperties& mass, const Vector3d& origin_B) {
  const physics::SymmetricEigen eigen = physics::symmetricEigen(mass.inertia_B());
  Vector3d I;
  Matrix3d R_BP;
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    I[k] = toDouble(eigen.values[i]);
    for (int row = 0; row < 3; ++row) R_BP(row, k) = toDouble(eigen.vectors[i][static_cast<std::size_t>(row)]);
  }
  const Vector3d squares = 1.5 / mass.mass_kg() * (Vector3d::Constant(I.sum()) - 2 * I);
  const Vector3d h = squares.cwiseMax(0).cwiseSqrt(), centre_B = mass.centre_B() - origin_B;
  const double size = h.maxCoeff() > kPoint * centre_B.norm() ? h.maxCoeff() : centre_B.norm();
  Figure figure;
  const Sketch sketch(figure, R_BP, centre_B);
  sketch.box(Vector3d::Zero(), h.cwiseMax(kThinnest * size));
  return figure;
}

/// Returns a cone with its apex at the fixed point. The axis of the cone is the principal axis that is nearest to
/// the direction of the centre of mass.
Figure equivalentConeFigure(const physics::PrincipalAxes& axes, const Vector3d& gravity_B) {
  const Vector3d gravity_P = axes.toP(gravity_B);
  int axis = 2;
  gravity_P.cwiseAbs().maxCoeff(&axis);
  const Vector3d lengths = equivalentCone(axes.moments(), axis);
  const double way = gravity_P[axis] < 0 ? -1 : 1;
  Matrix3d R_PS;  // S: axes of the cone, z from apex to base
  R_PS << Vector3d::Unit((axis + 1) % 3), way * Vector3d::Unit((axis + 2) % 3), way * Vector3d::Unit(axis);
  Figure figure;
  const Sketch sketch(figure, axes.q_BP().toRotationMatrix() * R_PS, Vector3d::Zero());
  addTop(sketch, {lengths[(axis + 1) % 3], lengths[(axis + 2) % 3], lengths[axis]});
  return figure;
}

Figure figureOf(const scene::Scene& scene) {
  const std::vector<scene::Part> shown = partsToShow(scene);
  if (!shown.empty()) return partsFigure(shown, originOfFigure(scene, shown));
  if (scene.body.mass) return uniformBoxFigure(*scene.body.mass, scene.body.fixedPoint_B());
  const Vector3d& gravity_B = scene.motion.forcing.gravity_B;
  if (!gravity_B.isZero(0)) return equivalentConeFigure(scene.body.axes, gravity_B);
  return equivalentBoxFigure(scene.body.axes);
}

}  // namespace

Vector3d equivalentBox(const physics::PrincipalMoments& moments) {
  // A uniform box with half edges h has I1 = m (h2² + h3²)/3, so h1² ~ I2 + I3 - I1, which is 0 up to rounding for
  // a lamina.
  const Vector3d I = moments.values() / moments.values().maxCoeff();
  const Vector3d squares = (Vector3d::Constant(I.sum()) - 2 * I).cwiseMax(0);
  const Vector3d h = squares.cwiseSqrt();
  return h.cwiseMax(kThinnest * h.maxCoeff()) / h.maxCoeff();
}

Vector3d equivalentCone(const physics::PrincipalMoments& moments, int axis) {
  // A cone with base semi-axes a, b and height h has about its apex ∫xx = 3/20 m a², ∫yy = 3/20 m b²,
  // ∫zz = 3/5 m h². I1 = ∫yy + ∫zz and cyclic, so ∫xx = (I2 + I3 - I1)/2.
  const Vector3d I = moments.values() / moments.values().maxCoeff();
  const Vector3d second = 0.5 * (Vector3d::Constant(I.sum()) - 2 * I).cwiseMax(0);
  Vector3d lengths = (20.0 / 3 * second).cwiseSqrt();
  lengths[axis] *= 0.5;
  return lengths.cwiseMax(kThinnest * lengths.maxCoeff()) / lengths.maxCoeff();
}

Palette BodyFigure::MarkFigure::painted(const Palette& colors) const {
  Palette painted = colors;
  painted.body = color                              ? draw::fromSrgb(*color)
                 : tone == physics::MarkTone::kDark ? colors.mark
                                                    : colors.lightMark;
  return painted;
}

BodyFigure::BodyFigure(const scene::Scene& scene)
    : figure_(figureOf(scene)), R_PB_(scene.body.axes.q_BP().toRotationMatrix().transpose()) {
  const Vector3d origin_B = originOfFigure(scene, partsToShow(scene));
  for (const scene::BodyMark& mark : scene.body.marks) {
    Figure figure = partsFigure({mark.part}, origin_B);
    figure.marks.clear();  // its edges would crowd those of the body
    marks_.push_back({std::move(figure), mark.tone, mark.color});
  }
  for (int i = 0; i < 3; ++i) {
    const Vector3d axis_B = R_PB_.row(i).transpose();
    const double ahead = axis_B.dot(supportPoint(axis_B)), behind = -axis_B.dot(supportPoint(-axis_B));
    reachAlongAxes_[i] = ahead;
    halfExtents_[i] = 0.5 * (ahead + behind);
  }
}

Vector3d BodyFigure::supportPoint(const Vector3d& direction_B) const {
  Vector3d best = Vector3d::Zero();
  double most = -std::numeric_limits<double>::infinity();
  for (const Piece& piece : figure_.pieces) {
    const Vector3d point = stage::supportPoint(piece, direction_B);
    if (point.dot(direction_B) <= most) continue;
    most = point.dot(direction_B);
    best = point;
  }
  return best;
}

std::vector<Vector3d> BodyFigure::outermostPoints(const Placement& place) const {
  std::vector<Vector3d> points;
  for (const Vector3d& direction_B : cubeDirections())
    points.push_back(place.origin_V + place.scale * (place.R_VB * supportPoint(direction_B)));
  return points;
}

double BodyFigure::gauge(const Vector3d& p_B) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Piece& piece : figure_.pieces) least = std::min(least, stage::gauge(piece, p_B));
  return least;
}

double BodyFigure::radius() const { return reachIn(Vector3d::Ones()); }

double BodyFigure::reachIn(const Vector3d& semiAxes_P) const {
  const Matrix3d A = semiAxes_P.cwiseInverse().asDiagonal() * R_PB_;
  double most = 0;
  for (const Piece& piece : figure_.pieces) most = std::max(most, farthest(piece, A));
  return most;
}

}  // namespace poinsot::stage
