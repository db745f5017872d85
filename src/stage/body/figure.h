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

/// Figures of bodies, made of solid pieces and lines on them. Coordinates are in body axes B, in m, with the fixed
/// point as origin.
namespace poinsot::stage {

enum class Paint { kBody, kRod };

struct EllipsoidPiece {
  Eigen::Vector3d centre_B = Eigen::Vector3d::Zero();
  Eigen::Matrix3d semiAxes_B = Eigen::Matrix3d::Identity();  ///< columns: semi-axes; rings go around the third
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

struct TubePiece {
  std::vector<Eigen::Vector3d> points_B;
  bool closed = false;
  double radius = 0;
};

/// Triangulated surface in axes M, whose origin is `centre_B`. The mesh has a size of about 1, because its
/// vertices are floats.
struct MeshPiece {
  std::shared_ptr<const draw::TriangleMesh> mesh;
  std::vector<Eigen::Vector4d> tangents_M;  ///< tangent planes (n, d): n·x <= d for all points x of the mesh
  Eigen::Vector3d centre_B = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes_B = Eigen::Matrix3d::Identity();
  bool edges = false;  ///< creases are drawn as lines, as on a polyhedron
  float gloss = 0.35f;
};

/// Returns a mesh as a piece of a figure, scaled to a size of about 1. R_BM and `origin_B` give the attitude and
/// the origin of the mesh's axes M.
/// @pre the mesh has vertices, not all in one point.
MeshPiece meshPiece(const geometry::Mesh& mesh, const Eigen::Matrix3d& R_BM, const Eigen::Vector3d& origin_B);

using Piece = std::variant<EllipsoidPiece, FrustumPiece, BoxPiece, TubePiece, MeshPiece>;

/// Line on a surface, such as an edge, a ring or a meridian, or a string of a racket. Lines on a part are left out
/// if the part is hardly wider than its lines in the picture. `width` is a multiple of the width of an ordinary
/// line.
struct Mark {
  std::vector<Eigen::Vector3d> points_B;
  bool closed = false;
  double width = 1;
  bool string = false;
  double part_m = std::numeric_limits<double>::infinity();  ///< thickness of the part under the mark
};

struct Figure {
  std::vector<Piece> pieces;
  std::vector<Mark> marks;
};

/// Returns the unit vectors from the centre of a cube through its 6 faces, 12 edges and 8 corners.
std::vector<Eigen::Vector3d> cubeDirections();

/// Returns the point of a piece that is farthest in a direction. @pre direction_B is not zero.
Eigen::Vector3d supportPoint(const Piece& piece, const Eigen::Vector3d& direction_B);

/// Returns the second largest of a piece's three extents, m, such as the thickness of a rod or the width of a
/// plate.
double thickness(const Piece& piece);

/// Returns the position of a point relative to a piece's surface: less than 1 inside, 1 on the surface, more than
/// 1 outside. Returns infinity if the piece is too thin to hide anything. A mesh counts as the solid between its
/// tangent planes.
double gauge(const Piece& piece, const Eigen::Vector3d& p_B);

/// Placement of the body axes B in the picture V: a rotation, a scale in picture lengths per metre, and the origin
/// of B.
struct Placement {
  Eigen::Matrix3d R_VB;
  double scale;
  Eigen::Vector3d origin_V = Eigen::Vector3d::Zero();
};

void addFigure(draw::DrawList& list, const Figure& figure, const Placement& place, const Palette& colors,
               double lineWidth_px);

}  // namespace poinsot::stage
