// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/construction_figures.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

constexpr double kHeightBeside = 1.08;  // distance of the dimension line, relative to the longest semi-axis
constexpr double kHeightEnds = 0.035;
constexpr double kContactRadius = 0.03;
constexpr double kPlaneNameSize = 0.57,
                 kNameGap = 1.2;  // plane's name: size relative to a label; gap relative to that size

// Directions to the faces and corners of a cube, without the opposite directions.
const Vector3d kDirections[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {-1, 1, 1}, {1, -1, 1}, {1, 1, -1}};

}  // namespace

EllipsoidFigure::EllipsoidFigure(const Setting& setting)
    : construction_(*setting.construction),
      opacity_(setting.scene.show.ellipsoid.opacity),
      graticule_(setting.scene.show.ellipsoid.graticule) {}

void EllipsoidFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  if (state.atRest()) return;
  // The graticule's poles are the ends of the longest axis, where crowded lines look most natural.
  int longest = 0;
  construction_.semiAxes().maxCoeff(&longest);
  const Eigen::Matrix3d axes = construction_.semiAxes_V(state);
  Eigen::Matrix3d polar;
  polar << axes.col((longest + 1) % 3), axes.col((longest + 2) % 3), axes.col(longest);
  draw::GlassEllipsoid& glass =
      canvas.glassEllipsoid(polar, canvas.colors.ellipsoid, opacity_, {.near = 0.5, .far = 1.2, .rim = 3.8});
  if (graticule_)
    glass.graticule =
        draw::Graticule{canvas.colors.graticule, static_cast<float>(0.8 * canvas.line_px), 0.75f, 0.3f};
}

std::vector<Vector3d> EllipsoidFigure::outermostPoints(const PictureState& state) const {
  if (state.atRest()) return {};
  std::vector<Vector3d> points;
  const Eigen::Matrix3d A = construction_.semiAxes_V(state);
  for (const Vector3d& direction : kDirections) {
    const Vector3d extreme = A * (A.transpose() * direction).normalized();
    points.push_back(extreme);
    points.push_back(-extreme);
  }
  return points;
}

PlaneFigure::PlaneFigure(const Setting& setting)
    : construction_(*setting.construction),
      opacity_(setting.scene.show.plane.opacity),
      grid_(setting.scene.show.plane.grid),
      shadow_(setting.scene.show.ellipsoid.visible) {}

void PlaneFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  if (state.atRest()) return;
  const Eigen::Matrix<double, 3, 2> halfEdges = construction_.planeHalfEdges_V(state);
  draw::GridPlane plane;
  plane.centre_V = toPicture(Vector3d(construction_.planeHeight(state) * state.L_V.normalized()));
  plane.u_V = toPicture(Vector3d(halfEdges.col(0)));
  plane.v_V = toPicture(Vector3d(halfEdges.col(1)));
  plane.spacing_V = static_cast<float>(construction_.gridSpacing() * construction_.scale());
  plane.color = canvas.colors.plane;
  plane.opacity = canvas.glass(opacity_);
  plane.lineColor = canvas.colors.planeLine;
  plane.lineOpacity = grid_ ? 0.5f : 0.0f;
  plane.lineWidth_px = static_cast<float>(0.8 * canvas.line_px);
  if (shadow_) {
    plane.shadowCentre_V = toPicture(Vector3d(construction_.scale() * state.omega_V));
    plane.shadowRadius_V = static_cast<float>(0.3 * construction_.semiAxes().minCoeff());
    plane.shadowOpacity = 0.22f;
  }
  canvas.list.planes.push_back(plane);
  addName(canvas, state);
}

// Places the name under the edge that runs from the left to the plane's lowest corner. If the plane is above the
// body, places the name over the edge that runs to the highest corner.
void PlaneFigure::addName(const Canvas& canvas, const PictureState& state) const {
  const auto corners_V = construction_.planeCorners_V(state);
  std::array<glm::vec2, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) corners[i] = canvas.at_px(corners_V[i]);
  const Vector3d centre_V = construction_.planeHeight(state) * state.L_V.normalized();
  const bool above = canvas.at_px(centre_V).y < canvas.at_px(Vector3d::Zero()).y;
  const auto outer = [above](glm::vec2 a, glm::vec2 b) { return above ? a.y > b.y : a.y < b.y; };
  const auto tip =
      static_cast<std::size_t>(std::max_element(corners.begin(), corners.end(), outer) - corners.begin());
  const glm::vec2 before = corners[(tip + 3) % 4], after = corners[(tip + 1) % 4];
  const glm::vec2 middle = 0.5f * ((before.x < after.x ? before : after) + corners[tip]);
  canvas.labelAt(scene::LabelName::kPlane, middle, {-0.6, above ? -1 : 1}, canvas.colors.L, kPlaneNameSize,
                 kNameGap);
}

std::vector<Vector3d> PlaneFigure::outermostPoints(const PictureState& state) const {
  if (state.atRest()) return {};
  const auto corners = construction_.planeCorners_V(state);
  return {corners.begin(), corners.end()};
}

ContactFigure::ContactFigure(const Setting& setting)
    : scale_(setting.construction->scale()), radius_(kContactRadius * setting.scene.show.contact.scale) {}

void ContactFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  if (state.atRest()) return;
  canvas.dot(scale_ * state.omega_V, radius_, canvas.colors.ink);
  canvas.point("contact", scale_ * state.omega_V);
}

std::vector<Vector3d> ContactFigure::outermostPoints(const PictureState& state) const {
  return {scale_ * state.omega_V};
}

HeightFigure::HeightFigure(const Setting& setting) : construction_(*setting.construction) {}

void HeightFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  if (state.atRest()) return;
  const Vector3d down = state.L_V.normalized();
  const Vector3d across = down.cross(fromPicture(canvas.list.camera.R_VC[2]));
  if (across.norm() < 0.05) return;  // seen along L, the line would be a point
  const Vector3d left = across.normalized();
  const Vector3d head = kHeightBeside * construction_.semiAxes().maxCoeff() * left;
  const Vector3d foot = construction_.planeHeight(state) * down + head;
  canvas.line({foot, head}, false, canvas.colors.L, 0.9);
  for (const Vector3d& end : {foot, head})
    canvas.line({end - kHeightEnds * left, end + kHeightEnds * left}, false, canvas.colors.L, 0.9);
  const glm::vec2 a = canvas.at_px(foot), b = canvas.at_px(head), middle = 0.5f * (a + b);
  glm::vec2 aside(a.y - b.y, b.x - a.x);
  if (glm::dot(aside, middle - canvas.at_px(Vector3d::Zero())) < 0) aside = -aside;
  canvas.labelAt(scene::LabelName::kHeight, middle, softUnit(aside, 0), canvas.colors.L, 0.72, 0.4);
}

std::vector<Vector3d> HeightFigure::outermostPoints(const PictureState& /*state*/) const { return {}; }

}  // namespace poinsot::stage
