// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "geometry/mesh.h"
#include "stage/body/figure.h"

namespace poinsot::stage {

/// `points` points of a closed curve, at equal steps of an angle from 0 to 2 pi.
std::vector<Eigen::Vector3d> loop(int points, const std::function<Eigen::Vector3d(double)>& at);

/// Adds to a figure what is described in a part's own axes S. Lengths in m.
class Sketch {
 public:
  Sketch(Figure& figure, const Eigen::Matrix3d& R_BS, const Eigen::Vector3d& origin_B)
      : figure_(figure), R_BS_(R_BS), origin_B_(origin_B) {}

  /// For axes T inside S.
  Sketch turned(const Eigen::Matrix3d& R_ST, const Eigen::Vector3d& origin_S) const {
    return {figure_, R_BS_ * R_ST, toB(origin_S)};
  }

  /// With semi-axes along x, y, z; marked with rings about the longest, or about z where it is nearly a ball.
  void ellipsoid(const Eigen::Vector3d& centre, const Eigen::Vector3d& semiAxes, bool marked = true) const;
  void ball(const Eigen::Vector3d& centre, double radius, Paint paint = Paint::kBody) const;
  void frustum(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double fromRadius, double toRadius,
               Paint paint = Paint::kBody) const;
  /// With its edges.
  void box(const Eigen::Vector3d& centre, const Eigen::Vector3d& halfEdges) const;
  void tube(const std::vector<Eigen::Vector3d>& points, bool closed, double radius) const;
  /// `edges`: its creases are lines.
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
