// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "geometry/mesh.h"
#include "stage/body/figure.h"

namespace poinsot::stage {

/// Returns `points` points of the closed curve `at`, whose argument runs from 0 to 2 pi in equal steps.
std::vector<Eigen::Vector3d> loop(int points, const std::function<Eigen::Vector3d(double)>& at);

/// Adds pieces and lines to a figure. Coordinates are in a part's own axes S, in m.
class Sketch {
 public:
  Sketch(Figure& figure, const Eigen::Matrix3d& R_BS, const Eigen::Vector3d& origin_B)
      : figure_(figure), R_BS_(R_BS), origin_B_(origin_B) {}

  Sketch turned(const Eigen::Matrix3d& R_ST, const Eigen::Vector3d& origin_S) const {
    return {figure_, R_BS_ * R_ST, toB(origin_S)};
  }

  /// Adds an ellipsoid with semi-axes along x, y, z. If `marked`, rings are drawn around the longest axis, or
  /// around z if the ellipsoid is nearly a ball.
  void ellipsoid(const Eigen::Vector3d& centre, const Eigen::Vector3d& semiAxes, bool marked = true) const;
  void ball(const Eigen::Vector3d& centre, double radius, Paint paint = Paint::kBody) const;
  void frustum(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double fromRadius, double toRadius,
               Paint paint = Paint::kBody) const;
  void box(const Eigen::Vector3d& centre, const Eigen::Vector3d& halfEdges) const;
  void tube(const std::vector<Eigen::Vector3d>& points, bool closed, double radius) const;
  /// Adds a mesh. @param edges  draw creases as lines
  void mesh(const geometry::Mesh& mesh, bool edges) const;
  void mark(const std::vector<Eigen::Vector3d>& points, bool closed, double width = 1) const;
  void string(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double width) const;

 private:
  Eigen::Vector3d toB(const Eigen::Vector3d& p) const { return origin_B_ + R_BS_ * p; }
  std::vector<Eigen::Vector3d> toB(const std::vector<Eigen::Vector3d>& points) const;

  Figure& figure_;
  Eigen::Matrix3d R_BS_;
  Eigen::Vector3d origin_B_;
};

}  // namespace poinsot::stage
