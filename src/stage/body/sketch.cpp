// SPDX-License-Identifier: Apache-2.0
#include "stage/body/sketch.h"

#include <numbers>

namespace poinsot::stage {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::vector<Vector3d> loop(int points, const std::function<Vector3d(double)>& at) {
  std::vector<Vector3d> result;
  for (int i = 0; i < points; ++i) result.push_back(at(2 * std::numbers::pi * i / points));
  return result;
}

std::vector<Vector3d> Sketch::toB(const std::vector<Vector3d>& points) const {
  std::vector<Vector3d> points_B;
  for (const Vector3d& p : points) points_B.push_back(toB(p));
  return points_B;
}

void Sketch::ellipsoid(const Vector3d& centre, const Vector3d& semiAxes, bool marked) const {
  int longest = 2;
  if (semiAxes.maxCoeff() > 1.1 * semiAxes.minCoeff()) semiAxes.maxCoeff(&longest);
  const Matrix3d axes = R_BS_ * semiAxes.asDiagonal();
  Matrix3d polar;
  polar << axes.col((longest + 1) % 3), axes.col((longest + 2) % 3), axes.col(longest);
  figure_.pieces.push_back(EllipsoidPiece{toB(centre), polar, marked});
}

void Sketch::ball(const Vector3d& centre, double radius, Paint paint) const {
  figure_.pieces.push_back(EllipsoidPiece{toB(centre), radius * R_BS_, false, paint});
}

void Sketch::frustum(const Vector3d& from, const Vector3d& to, double fromRadius, double toRadius,
                     Paint paint) const {
  figure_.pieces.push_back(FrustumPiece{toB(from), toB(to), fromRadius, toRadius, paint});
}

void Sketch::box(const Vector3d& centre, const Vector3d& h) const {
  figure_.pieces.push_back(BoxPiece{toB(centre), R_BS_ * h.asDiagonal()});
  const auto corner = [&](double x, double y, double z) {
    return Vector3d(centre + h.cwiseProduct(Vector3d(x, y, z)));
  };
  for (const double z : {-1.0, 1.0})
    mark({corner(-1, -1, z), corner(1, -1, z), corner(1, 1, z), corner(-1, 1, z)}, true);
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0}) mark({corner(x, y, -1), corner(x, y, 1)}, false);
}

void Sketch::tube(const std::vector<Vector3d>& points, bool closed, double radius) const {
  figure_.pieces.push_back(TubePiece{toB(points), closed, radius});
}

void Sketch::mesh(const geometry::Mesh& mesh, bool edges) const {
  MeshPiece piece = meshPiece(mesh, R_BS_, origin_B_);
  piece.edges = edges;
  piece.gloss = edges ? 0.15f : 0.35f;  // less gloss on flat faces, because a highlight covers a complete face
  figure_.pieces.push_back(std::move(piece));
}

void Sketch::mark(const std::vector<Vector3d>& points, bool closed, double width) const {
  figure_.marks.push_back({toB(points), closed, width});
}

void Sketch::string(const Vector3d& from, const Vector3d& to, double width) const {
  figure_.marks.push_back({{toB(from), toB(to)}, false, width, true});
}

}  // namespace poinsot::stage
