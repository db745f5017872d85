// SPDX-License-Identifier: Apache-2.0
#include "stage/body/parts_figure.h"

#include <algorithm>
#include <cmath>

#include "geometry/mesh_integrals.h"
#include "physics/mass_properties.h"
#include "stage/body/solid_sketch.h"

namespace poinsot::stage {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using MeshPointer = std::shared_ptr<const geometry::Mesh>;

// Radii, as fractions of the greatest distance of a part from the centre of mass.
constexpr double kLargestBall = 0.15, kRod = 0.013;

/// Returns the centre of the volume that a mesh encloses. If the mesh is not closed, this centre may not exist, or
/// it may lie outside the bounding box. The middle of the bounding box is returned instead.
Vector3d centreOf(const geometry::Mesh& mesh) {
  const geometry::Bounds box = geometry::boundsOf(mesh);
  const Vector3d centre_M = geometry::integrals(mesh).centre_M;
  const bool inside =
      (centre_M.array() >= box.low_M.array()).all() && (centre_M.array() <= box.high_M.array()).all();
  return inside ? centre_M : box.centre_M();
}

struct CentreInS {
  Vector3d operator()(const physics::Solid& solid) const { return physics::massProperties(solid, 1).centre_B(); }
  Vector3d operator()(const MeshPointer& mesh) const { return centreOf(*mesh); }
  Vector3d operator()(const scene::PointMass&) const { return Vector3d::Zero(); }
};

Vector3d centreOf(const scene::Part& part) {
  return part.offset_B + part.q_BS * std::visit(CentreInS{}, part.figure);
}

Vector3d centreOfMass(const std::vector<scene::Part>& parts) {
  Vector3d moment = Vector3d::Zero();
  double mass = 0;
  for (const scene::Part& part : parts) {
    moment += part.mass_kg * centreOf(part);
    mass += part.mass_kg;
  }
  return moment / mass;
}

bool isPoint(const scene::Part& part) { return std::holds_alternative<scene::PointMass>(part.figure); }

double heaviestPoint(const std::vector<scene::Part>& parts) {
  double heaviest = 0;
  for (const scene::Part& part : parts)
    if (isPoint(part)) heaviest = std::max(heaviest, part.mass_kg);
  return heaviest;
}

/// Adds point masses as balls of equal density. Rods join the balls, so that several masses look like one body.
/// The heaviest ball has a fixed size.
void addPointMasses(Figure& figure, const std::vector<scene::Part>& parts, const Vector3d& origin_B) {
  const double heaviest = heaviestPoint(parts);
  if (heaviest == 0) return;
  const Vector3d centre_B = centreOfMass(parts);
  double extent = 0;
  for (const scene::Part& part : parts) extent = std::max(extent, (centreOf(part) - centre_B).norm());
  if (extent == 0) extent = 1;
  const Sketch sketch(figure, Matrix3d::Identity(), -origin_B);
  for (const scene::Part& part : parts) {
    if (!isPoint(part)) continue;
    sketch.ball(part.offset_B, kLargestBall * extent * std::cbrt(part.mass_kg / heaviest));
    if ((part.offset_B - centre_B).norm() > 1e-9 * extent)
      sketch.frustum(centre_B, part.offset_B, kRod * extent, kRod * extent, Paint::kRod);
  }
  sketch.ball(centre_B, 1.6 * kRod * extent, Paint::kRod);
}

void markThickness(Figure& figure, std::size_t firstPiece, std::size_t firstMark) {
  double most = 0;
  for (std::size_t i = firstPiece; i < figure.pieces.size(); ++i)
    most = std::max(most, thickness(figure.pieces[i]));
  for (std::size_t i = firstMark; i < figure.marks.size(); ++i)
    if (!figure.marks[i].string) figure.marks[i].part_m = most;
}

}  // namespace

std::vector<scene::Part> partsToShow(const scene::Scene& scene) {
  return scene.show.body.parts.empty() ? scene.body.parts : scene.show.body.parts;
}

Vector3d originOfFigure(const scene::Scene& scene, const std::vector<scene::Part>& shown) {
  const bool pivoted = scene.body.pivot_B || !scene.motion.forcing.gravity_B.isZero(0);
  return !scene.show.body.parts.empty() && !pivoted ? centreOfMass(shown) : scene.body.fixedPoint_B();
}

Figure partsFigure(const std::vector<scene::Part>& parts, const Vector3d& origin_B) {
  Figure figure;
  for (const scene::Part& part : parts) {
    const std::size_t firstPiece = figure.pieces.size(), firstMark = figure.marks.size();
    const Sketch sketch(figure, part.q_BS.toRotationMatrix(), part.offset_B - origin_B);
    if (const auto* solid = std::get_if<physics::Solid>(&part.figure)) addSolid(sketch, *solid);
    if (const auto* mesh = std::get_if<MeshPointer>(&part.figure)) sketch.mesh(**mesh, true);
    markThickness(figure, firstPiece, firstMark);
  }
  addPointMasses(figure, parts, origin_B);
  return figure;
}

}  // namespace poinsot::stage
