// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <variant>
#include <vector>

#include "draw/draw_list.h"
#include "geometry/mesh.h"
#include "stage/palette.h"

/// What a body is drawn with: solid pieces and the lines on them, in axes B with the fixed point as origin, in m.
namespace poinsot::stage {

enum class Paint { kBody, kRod };

struct EllipsoidPiece {
  Eigen::Vector3d centre_B = Eigen::Vector3d::Zero();
  Eigen::Matrix3d semiAxes_B = Eigen::Matrix3d::Identity();  ///< in its columns; rings go about the third
  bool marked = false;
  Paint paint = Paint::kBody;
};

struct FrustumPiece {
  Eigen::Vector3d from_B, to_B;
  double fromRadius = 0, toRadius = 0;
  Paint paint = Paint::kBody;
};

struct BoxPiece {
  Eigen::Vector3d centre_B = Eigen::Vector3d::Zero();
  Eigen::Matrix3d halfAxes_B = Eigen::Matrix3d::Identity();
};

/// A round tube along a smooth curve.
struct TubePiece {
  std::vector<Eigen::Vector3d> points_B;
  bool closed = false;
  double radius = 0;
};

/// A triangulated surface, in axes M with origin at `centre_B` and of a size of about 1: its vertices are floats.
struct MeshPiece {
  std::shared_ptr<const draw::TriangleMesh> mesh;
  std::vector<Eigen::Vector4d> tangents_M;  ///< planes that touch it, (n, d): n·x <= d
  Eigen::Vector3d centre_B = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes_B = Eigen::Matrix3d::Identity();
  bool edges = false;  ///< creases are lines, as on a polyhedron
  float gloss = 0.35f;
};

/// @pre the mesh has vertices, not all in one point.
MeshPiece meshPiece(const geometry::Mesh& mesh, const Eigen::Matrix3d& R_BM, const Eigen::Vector3d& origin_B);

using Piece = std::variant<EllipsoidPiece, FrustumPiece, BoxPiece, TubePiece, MeshPiece>;

/// A line on a surface: an edge, a ring, a meridian. `width` in ordinary lines. A part that is hardly wider than
/// its lines in the picture has none. Or a string, by itself.
struct Mark {
  std::vector<Eigen::Vector3d> points_B;
  bool closed = false;
  double width = 1;
  bool string = false;
  double part_m = std::numeric_limits<double>::infinity();  ///< how thick what it is on is
};

struct Figure {
  std::vector<Piece> pieces;
  std::vector<Mark> marks;
};

/// Unit vectors from the centre of a cube through its 6 faces, 12 edges and 8 corners.
std::vector<Eigen::Vector3d> cubeDirections();

/// The piece's farthest point in a direction. @pre direction_B is not zero.
Eigen::Vector3d supportPoint(const Piece& piece, const Eigen::Vector3d& direction_B);

/// The second of its three extents, m: a rod's thickness, a plate's width.
double thickness(const Piece& piece);

/// How far out a point lies: 1 on the piece's surface, less inside; infinite where the piece is too thin to hide
/// anything. Of a mesh, what lies between its tangent planes counts.
double gauge(const Piece& piece, const Eigen::Vector3d& p_B);

/// B's place in the picture V: turned, scaled by picture lengths per metre, its origin at a place of the picture.
struct Placement {
  Eigen::Matrix3d R_VB;
  double scale;
  Eigen::Vector3d origin_V = Eigen::Vector3d::Zero();
};

void addFigure(draw::DrawList& list, const Figure& figure, const Placement& place, const Palette& colors,
               double lineWidth_px);

}  // namespace poinsot::stage
