// SPDX-License-Identifier: Apache-2.0
#include "stage/body/solid_sketch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/primitives.h"
#include "stage/body/hollow_box_mesh.h"
#include "stage/body/round_sketch.h"

namespace poinsot::stage {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kPlateHalfThickness = 0.02;  // half the drawn thickness, as a fraction of the longest edge

Matrix3d zAlong(int axis) {
  Matrix3d R;
  R << Vector3d::Unit((axis + 1) % 3), Vector3d::Unit((axis + 2) % 3), Vector3d::Unit(axis);
  return R;
}

void add(const Sketch& sketch, const physics::Box& solid) { sketch.box({0, 0, 0}, 0.5 * solid.edges_m); }

void add(const Sketch& sketch, const physics::HollowBox& solid) {
  sketch.mesh(hollowBoxMesh(solid.edges_m, solid.wall_m), true);
}

void add(const Sketch& sketch, const physics::Plate& solid) {
  const double h = kPlateHalfThickness * solid.edges_m.maxCoeff();
  sketch.box({0, 0, 0}, {0.5 * solid.edges_m.x(), 0.5 * solid.edges_m.y(), h});
}

geometry::Mesh regular(const physics::Polyhedron& solid) {
  switch (solid.kind) {
    case physics::PolyhedronKind::kTetrahedron:
      return geometry::tetrahedronMesh(solid.edge_m);
    case physics::PolyhedronKind::kCube:
      return geometry::cubeMesh(solid.edge_m);
    case physics::PolyhedronKind::kOctahedron:
      return geometry::octahedronMesh(solid.edge_m);
    case physics::PolyhedronKind::kDodecahedron:
      return geometry::dodecahedronMesh(solid.edge_m);
    case physics::PolyhedronKind::kIcosahedron:
      return geometry::icosahedronMesh(solid.edge_m);
  }
  return {};
}

void add(const Sketch& sketch, const physics::Polyhedron& solid) { sketch.mesh(regular(solid), true); }

void add(const Sketch& sketch, const physics::LPlate& solid) {
  const double thickness = 2 * kPlateHalfThickness * solid.edges_m.maxCoeff();
  sketch.mesh(geometry::lPrismMesh(solid.edges_m, solid.arm_m, thickness), true);
}

// The shaft ends at the bar's axis, because a flat end under the round bar would leave a visible gap.
void add(const Sketch& sketch, const physics::THandle& solid) {
  const double end = solid.barRadius_m + solid.shaftLength_m;
  add(sketch.turned(zAlong(0), {0, 0, 0}), physics::Cylinder{solid.barRadius_m, solid.barLength_m});
  add(sketch.turned(zAlong(1), {0, 0.5 * end, 0}), physics::Cylinder{solid.shaftRadius_m, end});
}

// Each wing extends inwards until its corners reach the round surface of the hub.
void add(const Sketch& sketch, const physics::WingNut& solid) {
  add(sketch, physics::Cylinder{solid.hubRadius_m, solid.hubHeight_m});
  const Vector3d h = 0.5 * solid.wing_m;
  const double outer = solid.wingCentre_m + h.x(),
               inHub = std::sqrt(std::max(solid.hubRadius_m * solid.hubRadius_m - h.y() * h.y(), 0.0));
  const double inner = std::min(solid.wingCentre_m - h.x(), inHub);
  for (const double side : {-1.0, 1.0})
    sketch.box({side * 0.5 * (inner + outer), 0, solid.wingRise_m}, {0.5 * (outer - inner), h.y(), h.z()});
}

void addStrings(const Sketch& sketch, double R, double frame) {
  constexpr int kStrings = 9;
  for (int i = 1; i < kStrings; ++i) {
    const double c = R * (2.0 * i / kStrings - 1), half = std::sqrt(R * R - c * c) - 0.8 * frame;
    sketch.string({c, -half, 0}, {c, half, 0}, 0.7);
    sketch.string({-half, c, 0}, {half, c, 0}, 0.7);
  }
}

void add(const Sketch& sketch, const physics::Racket& solid) {
  const double frame = 0.035 * solid.width_m, R = 0.5 * solid.width_m;
  const double handle = solid.length_m - solid.width_m, butt = -R - handle;
  const auto onHoop = [&](double angle) { return Vector3d(R * std::cos(angle), R * std::sin(angle), 0); };
  sketch.tube(loop(128, onHoop), true, frame);
  addStrings(sketch, R, frame);
  const Vector3d fork(butt + 0.62 * handle, 0, 0), grip(butt + 0.5 * handle, 0, 0);
  for (const double angle : {0.78 * std::numbers::pi, -0.78 * std::numbers::pi})
    sketch.tube({fork, onHoop(angle)}, false, 0.8 * frame);
  sketch.tube({grip, fork}, false, 1.1 * frame);
  sketch.frustum({butt, 0, 0}, grip, 1.75 * frame, 1.55 * frame);
}

}  // namespace

void addSolid(const Sketch& sketch, const physics::Solid& solid) {
  std::visit([&](const auto& kind) { add(sketch, kind); }, solid);
}

}  // namespace poinsot::stage
