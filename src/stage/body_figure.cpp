// SPDX-License-Identifier: Apache-2.0
#include "stage/body_figure.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kThinnest = 0.07;  // of the longest half edge: what is drawn of a lamina

/// Puts points given in body axes, in metres, into the picture.
struct Placement {
  Matrix3d R_VB;
  double scale;
  glm::vec3 operator()(const Vector3d& p_B) const { return toPicture(Vector3d(scale * (R_VB * p_B))); }
  float length(double metres) const { return static_cast<float>(scale * metres); }
};

struct Pen {
  draw::DrawList& list;
  Placement place;
  const Palette& colors;
  double lineWidth_px;

  void line(const std::vector<Vector3d>& points_B, bool closed, double width = 1) const {
    draw::Curve curve;
    for (const Vector3d& p : points_B) curve.points_W.push_back(place(p));
    curve.closed = closed;
    curve.width_px = static_cast<float>(width * lineWidth_px);
    curve.lift_W = 0.02f;
    curve.material.color = colors.bodyEdge;
    list.curves.push_back(std::move(curve));
  }

  void tube(const std::vector<Vector3d>& points_B, bool closed, double radius_m) const {
    draw::Curve curve;
    for (const Vector3d& p : points_B) curve.points_W.push_back(place(p));
    curve.closed = closed;
    curve.radius_W = place.length(radius_m);
    curve.material.color = colors.body;
    list.curves.push_back(std::move(curve));
  }

  void frustum(const Vector3d& from_B, const Vector3d& to_B, double fromRadius, double toRadius) const {
    list.frustums.push_back(
        {place(from_B), place(to_B), place.length(fromRadius), place.length(toRadius), {colors.body, 0.35f}});
  }
};

std::vector<Vector3d> loop(int points, const std::function<Vector3d(double)>& at) {
  std::vector<Vector3d> result;
  for (int i = 0; i < points; ++i) result.push_back(at(2 * std::numbers::pi * i / points));
  return result;
}

void addBox(const Pen& pen, const Vector3d& h) {
  pen.list.boxes.push_back({glm::vec3(0),
                            toPicture(Matrix3d(pen.place.scale * pen.place.R_VB * h.asDiagonal())),
                            {pen.colors.body, 0.15f}});
  for (const double z : {-h.z(), h.z()})
    pen.line({{-h.x(), -h.y(), z}, {h.x(), -h.y(), z}, {h.x(), h.y(), z}, {-h.x(), h.y(), z}}, true);
  for (const double x : {-h.x(), h.x()})
    for (const double y : {-h.y(), h.y()}) pen.line({{x, y, -h.z()}, {x, y, h.z()}}, false);
}

// Its rings go about the longest axis, or about z where it is nearly a ball.
void addEllipsoid(const Pen& pen, const Vector3d& h) {
  int longest = 2;
  if (h.maxCoeff() > 1.1 * h.minCoeff()) h.maxCoeff(&longest);
  const Matrix3d axes = pen.place.scale * pen.place.R_VB * h.asDiagonal();
  Matrix3d polar;
  polar << axes.col((longest + 1) % 3), axes.col((longest + 2) % 3), axes.col(longest);
  pen.list.ellipsoids.push_back({glm::vec3(0),
                                 toPicture(polar),
                                 {pen.colors.body, 0.5f},
                                 pen.colors.bodyEdge,
                                 static_cast<float>(pen.lineWidth_px)});
}

void addCylinder(const Pen& pen, const Vector3d& h) {
  pen.frustum({0, 0, -h.z()}, {0, 0, h.z()}, h.x(), h.x());
  const auto rim = [&](double z) {
    return loop(96, [&, z](double s) { return Vector3d(h.x() * std::cos(s), h.x() * std::sin(s), z); });
  };
  pen.line(rim(-h.z()), true);
  pen.line(rim(h.z()), true);
  for (const double angle : {0.0, 2.0944, 4.1888}) {
    const double x = h.x() * std::cos(angle), y = h.x() * std::sin(angle);
    pen.line({{x, y, -h.z()}, {x, y, h.z()}}, false, angle == 0 ? 1.8 : 1);
    pen.line({{0, 0, h.z()}, {x, y, h.z()}}, false, angle == 0 ? 1.8 : 1);
    pen.line({{0, 0, -h.z()}, {x, y, -h.z()}}, false, angle == 0 ? 1.8 : 1);
  }
}

// Where the racket's parts are along its axis x, from the centre of mass (table 3.1 of the inertia: masses of hoop
// and handle rod 0.17 : 0.16).
struct RacketPlan {
  double hoopRadius, hoopCentre, butt, throat;
  explicit RacketPlan(const Vector3d& size) {
    const double handle = size.x() - size.y();
    hoopRadius = 0.5 * size.y();
    const double centre = (0.16 * 0.5 * handle + 0.17 * (handle + hoopRadius)) / 0.33;
    butt = -centre;
    throat = handle - centre;
    hoopCentre = throat + hoopRadius;
  }
};

void addRacket(const Pen& pen, const Vector3d& size) {
  const RacketPlan plan(size);
  const double frame = 0.035 * size.y(), R = plan.hoopRadius;
  const auto onHoop = [&](double angle) {
    return Vector3d(plan.hoopCentre + R * std::cos(angle), R * std::sin(angle), 0);
  };
  pen.tube(loop(128, onHoop), true, frame);
  constexpr int kStrings = 9;
  for (int i = 1; i < kStrings; ++i) {
    const double c = R * (2.0 * i / kStrings - 1), half = std::sqrt(R * R - c * c) - 0.8 * frame;
    pen.line({{plan.hoopCentre + c, -half, 0}, {plan.hoopCentre + c, half, 0}}, false, 0.7);
    pen.line({{plan.hoopCentre - half, c, 0}, {plan.hoopCentre + half, c, 0}}, false, 0.7);
  }
  const double handle = plan.throat - plan.butt;
  const Vector3d fork(plan.butt + 0.62 * handle, 0, 0), grip(plan.butt + 0.5 * handle, 0, 0);
  for (const double angle : {0.78 * std::numbers::pi, -0.78 * std::numbers::pi})
    pen.tube({fork, onHoop(angle)}, false, 0.8 * frame);
  pen.tube({grip, fork}, false, 1.1 * frame);
  pen.frustum({plan.butt, 0, 0}, grip, 1.75 * frame, 1.55 * frame);
}

}  // namespace

Vector3d equivalentBox(const physics::PrincipalMoments& moments) {
  // Uniform box with half edges h: I1 = m (h2² + h3²) / 3, so h1² ~ I2 + I3 - I1; a lamina's is 0 up to rounding.
  const Vector3d I = moments.values() / moments.values().maxCoeff();
  const Vector3d squares = (Vector3d::Constant(I.sum()) - 2 * I).cwiseMax(0);
  const Vector3d h = squares.cwiseSqrt();
  return h.cwiseMax(kThinnest * h.maxCoeff()) / h.maxCoeff();
}

BodyFigure::BodyFigure(const scene::Scene& scene) {
  if (scene.show.body.shape)
    shape_ = *scene.show.body.shape;
  else if (scene.body.shape)
    shape_ = *scene.body.shape;
  else
    shape_ = {scene::ShapeKind::kBox, 2 * equivalentBox(scene.body.axes.moments())};
  halfExtents_ = 0.5 * shape_.size_m;
}

std::vector<Vector3d> BodyFigure::outermostPoints() const {
  const Vector3d& h = halfExtents_;
  std::vector<Vector3d> points;
  if (shape_.kind == scene::ShapeKind::kRacket) {
    const RacketPlan plan(shape_.size_m);
    points.emplace_back(plan.butt, 0, 0);
    for (int i = -6; i <= 6; ++i) {
      const double angle = std::numbers::pi * i / 6;
      points.emplace_back(plan.hoopCentre + plan.hoopRadius * std::cos(angle), plan.hoopRadius * std::sin(angle),
                          0);
    }
  } else if (shape_.kind == scene::ShapeKind::kEllipsoid) {
    for (int axis = 0; axis < 3; ++axis) points.push_back(h[axis] * Vector3d::Unit(axis));
  } else if (shape_.kind == scene::ShapeKind::kCylinder) {
    for (const double angle : {0.0, 0.25, 0.5, 0.75})
      points.emplace_back(h.x() * std::cos(2 * std::numbers::pi * angle),
                          h.y() * std::sin(2 * std::numbers::pi * angle), h.z());
  } else {
    points.push_back(h);
  }
  return points;
}

double BodyFigure::gauge(const Vector3d& p_B) const {
  const Vector3d q = p_B.cwiseAbs().cwiseQuotient(halfExtents_);
  switch (shape_.kind) {
    case scene::ShapeKind::kBox:
      return q.maxCoeff();
    case scene::ShapeKind::kEllipsoid:
      return q.norm();
    case scene::ShapeKind::kCylinder:
      return std::max(std::hypot(q.x(), q.y()), q.z());
    case scene::ShapeKind::kRacket:
      return std::numeric_limits<double>::infinity();  // one sees through it
  }
  return 0;
}

double BodyFigure::radius() const {
  double farthest = 0;
  for (const Vector3d& p : outermostPoints()) farthest = std::max(farthest, p.norm());
  return farthest;
}

double BodyFigure::reachIn(const Vector3d& semiAxes) const {
  double farthest = 0;
  for (const Vector3d& p : outermostPoints()) farthest = std::max(farthest, p.cwiseQuotient(semiAxes).norm());
  return farthest;
}

void BodyFigure::add(draw::DrawList& list, const Matrix3d& R_VB, double scale, const Palette& colors,
                     double lineWidth_px) const {
  const Pen pen{list, {R_VB, scale}, colors, lineWidth_px};
  switch (shape_.kind) {
    case scene::ShapeKind::kBox:
      return addBox(pen, halfExtents_);
    case scene::ShapeKind::kEllipsoid:
      return addEllipsoid(pen, halfExtents_);
    case scene::ShapeKind::kCylinder:
      return addCylinder(pen, halfExtents_);
    case scene::ShapeKind::kRacket:
      return addRacket(pen, shape_.size_m);
  }
}

}  // namespace poinsot::stage
