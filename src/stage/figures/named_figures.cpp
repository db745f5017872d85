// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/named_figures.h"

#include <algorithm>
#include <cmath>

#include "stage/figures/point_name.h"
#include "stage/figures/symmetric_top.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;
using scene::Direction;

constexpr double kArrowRadius = 0.016;
constexpr double kHiddenWidth = 1.4;  // width of the dashes of an arrow in the body
constexpr double kArcShare = 0.72;    // radius of an arc, as a fraction of the shorter arrow
constexpr double kVertical = 1.15;
constexpr double kSpaceAxisReach = 1.15;  // length of a space axis, as a multiple of Scales::reach
constexpr int kArcPoints = 48;

draw::Color colorOf(const Palette& colors, scene::Meaning meaning) {
  switch (meaning) {
    case scene::Meaning::kVector:
      break;
    case scene::Meaning::kInk:
      return colors.ink;
    case scene::Meaning::kL:
      return colors.L;
    case scene::Meaning::kOmega:
      return colors.omega;
    case scene::Meaning::kBody:
      return colors.body;
    case scene::Meaning::kAxis:
      return colors.axis;
    case scene::Meaning::kTorque:
      return colors.torque;
  }
  return colors.vector;
}

using Arrow = NamedVectorFigure::Arrow;
using ArrowOf = std::function<Arrow(const PictureState&)>;

/// Returns the axes of a frame as columns, along V.
std::function<Eigen::Matrix3d(const PictureState&)> axesOf(const Setting& setting, scene::VectorFrame frame) {
  switch (frame) {
    case scene::VectorFrame::kSpace:
      break;
    case scene::VectorFrame::kBody:
      return [](const PictureState& state) { return state.R_VB; };
    case scene::VectorFrame::kPrincipal:
      return [](const PictureState& state) { return state.R_VP; };
    case scene::VectorFrame::kOwn: {
      const Eigen::Matrix3d R_BA =
          setting.scene.body.q_BA.value_or(physics::Quaternion::Identity()).toRotationMatrix();
      return [R_BA](const PictureState& state) -> Eigen::Matrix3d { return state.R_VB * R_BA; };
    }
    case scene::VectorFrame::kPrecession:
      return [cones = triadOf(setting.motion, "vector[].frame")](const PictureState& state) {
        return triad_V(state, cones);
      };
  }
  return [](const PictureState& state) { return state.R_VW; };
}

struct MakeArrow {
  const Setting& setting;
  double scale;

  Vector3d place_B(const Vector3d& point_B) const {
    return setting.scales.body * (point_B - setting.scene.body.fixedPoint_B());
  }

  ArrowOf operator()(const scene::FixedVector& vector) const {
    const Vector3d tip = scale * setting.scales.reach * vector.components.normalized();
    return [tip, axes = axesOf(setting, vector.frame)](const PictureState& state) {
      return Arrow{Vector3d::Zero(), axes(state) * tip};
    };
  }

  /// The arrow r starts at the point K by which the scene throws the body (eq 4), otherwise at the fixed point.
  ArrowOf operator()(const scene::PositionVector& vector) const {
    const Vector3d from_B = setting.scales.body * scene::referencePoint_B(setting.scene);
    const Vector3d tip_B = from_B + scale * (place_B(vector.point_B) - from_B);
    return [from_B, tip_B, extent = 2 * setting.scales.reach](const PictureState& state) {
      return Arrow{.from_V = state.R_VB * from_B, .tip_V = state.R_VB * tip_B, .inBody_V = extent};
    };
  }

  ArrowOf operator()(const scene::VelocityVector& vector) const {
    const Vector3d r_B = vector.point_B - setting.scene.body.fixedPoint_B(),
                   K_B = scene::referencePoint_B(setting.scene);
    return [r_B, K_B, body = setting.scales.body,
            factor = scale * setting.scales.velocity](const PictureState& state) {
      const Vector3d place_V = body * (state.R_VB * r_B);
      Arrow arrow{place_V, place_V + factor * state.velocityAt(r_B)};
      if (!state.velocity_V.isZero(0)) arrow.corner_V = place_V + factor * state.velocityAt(K_B);
      return arrow;
    };
  }
};

}  // namespace

Directions::Directions(const Setting& setting)
    : axis_P_(mainAxis_P(setting.motion)),
      axisLengths_(setting.axisLengths),
      reach_(kSpaceAxisReach * setting.scales.reach),
      L_(0),
      omega_(0) {
  for (const PathPoint& p : setting.motion.outline()) {
    L_ = std::max(L_, setting.scales.L * p.L_W.norm());
    omega_ = std::max(omega_, setting.scales.omega * p.omega_W.norm());
  }
}

Vector3d Directions::operator()(Direction direction, const PictureState& state) const {
  const auto unit = [](const Vector3d& v) { return v.isZero(0) ? v : Vector3d(v.normalized()); };
  switch (direction) {
    case Direction::kL:
      return unit(state.L_V);
    case Direction::kOmega:
      return unit(state.omega_V);
    case Direction::kTorque:
      return unit(state.torque_V);
    case Direction::kAxis:
      return state.R_VP * axis_P_;
    case Direction::kE1:
    case Direction::kE2:
    case Direction::kE3:
      return state.R_VP.col(static_cast<int>(direction) - static_cast<int>(Direction::kE1));
    case Direction::kX:
    case Direction::kY:
    case Direction::kZ:
      break;
  }
  return state.R_VW.col(static_cast<int>(direction) - static_cast<int>(Direction::kX));
}

double Directions::length(Direction direction) const {
  switch (direction) {
    case Direction::kL:
      return L_;
    case Direction::kOmega:
      return omega_;
    case Direction::kAxis:
      return axisLengths_.dot(axis_P_.cwiseAbs());
    case Direction::kE1:
    case Direction::kE2:
    case Direction::kE3:
      return axisLengths_[static_cast<int>(direction) - static_cast<int>(Direction::kE1)];
    default:
      return reach_;
  }
}

NamedVectorFigure::NamedVectorFigure(const Setting& setting, const scene::NamedVector& vector)
    : vector_(vector),
      pointName_(pointName(vector.name)),
      arrow_(std::visit(MakeArrow{setting, vector.scale}, vector.what)) {}

void NamedVectorFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  const Arrow now = arrow(state);
  const draw::Color color = colorOf(canvas.colors, vector_.color);
  canvas.arrowFrom(now.from_V, now.tip_V, kArrowRadius, color);
  if (now.inBody_V > 0) canvas.dashes(now.from_V, now.tip_V, color, kHiddenWidth, now.inBody_V);
  canvas.point(pointName_, now.tip_V);
  if (now.corner_V) {
    canvas.dashes(now.from_V, *now.corner_V, color);
    canvas.dashes(*now.corner_V, now.tip_V, color);
  }
  canvas.label(vector_.name, now.tip_V, now.from_V, color);
}

std::vector<Vector3d> NamedVectorFigure::outermostPoints(const PictureState& state) const {
  const Arrow now = arrow(state);
  return {now.from_V, now.tip_V, now.corner_V.value_or(now.tip_V)};
}

AngleFigure::AngleFigure(const Setting& setting, const scene::NamedAngle& angle, bool framed)
    : directions_(setting),
      angle_(angle),
      radius_(angle.scale * kArcShare * std::min(directions_.length(angle.from), directions_.length(angle.to))),
      framed_(framed) {}

// Computes points of the arc as (sin((1 - s) theta) a + sin(s theta) b) / sin(theta). This formula is exact at
// both ends and needs no axis of rotation.
std::vector<Vector3d> AngleFigure::arc(const PictureState& state) const {
  const Vector3d a = directions_(angle_.from, state), b = directions_(angle_.to, state);
  const double theta = std::atan2(a.cross(b).norm(), a.dot(b));
  if (a.isZero(0) || b.isZero(0) || !(std::sin(theta) > 1e-9)) return {};
  std::vector<Vector3d> points;
  for (int i = 0; i <= kArcPoints; ++i) {
    const double s = static_cast<double>(i) / kArcPoints;
    points.push_back(radius_ / std::sin(theta) * (std::sin((1 - s) * theta) * a + std::sin(s * theta) * b));
  }
  return points;
}

void AngleFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  const std::vector<Vector3d> points = arc(state);
  if (points.empty()) return;
  canvas.line(points, false, canvas.colors.ink, 1.6);
  canvas.label(angle_.name, points[points.size() / 2], Vector3d::Zero(), canvas.colors.ink);
}

std::vector<Vector3d> AngleFigure::outermostPoints(const PictureState& state) const {
  return framed_ ? arc(state) : std::vector<Vector3d>();
}

ThetaFigure::ThetaFigure(const Setting& setting)
    : fromVertical_(!setting.scene.motion.forcing.gravity_B.isZero(0) || setting.scene.motion.rolling),
      angle_(setting, {.from = fromVertical_ ? Direction::kZ : Direction::kL,
                       .to = Direction::kAxis,
                       .name = setting.scene.labels[scene::LabelName::kTheta],
                       .scale = setting.scene.show.figures.theta.scale}) {}

void ThetaFigure::add(const Canvas& canvas, double filmTime_s, const PictureState& state) const {
  if (fromVertical_) canvas.dashes(Vector3d::Zero(), kVertical * state.R_VW.col(2), canvas.colors.quietInk, 1.1);
  angle_.add(canvas, filmTime_s, state);
}

std::vector<Vector3d> ThetaFigure::outermostPoints(const PictureState& state) const {
  std::vector<Vector3d> points = angle_.outermostPoints(state);
  if (fromVertical_) points.emplace_back(kVertical * state.R_VW.col(2));
  return points;
}

}  // namespace poinsot::stage
