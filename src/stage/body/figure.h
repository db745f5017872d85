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

/// Figures of bodies: solid pieces and the lines on them, in axes B with the fixed point as origin, in m.
namespace poinsot::stage {

enum class Paint { kBody, kRod };

struct EllipsoidPiece {
  Eigen::Vector3d centre_B = Eigen::Vector3d::Zero();
  Eigen::Matrix3d semiAxes_B = Eigen::Matrix3d::Identity();  ///< semi-axes as columns; rings go about the third
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
  std::vector<Eigen::Vector4d> tangents_M;  ///< tangent planes (n, d) of the mesh: n·x <= d
  Eigen::Vector3d centre_B = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes_B = Eigen::Matrix3d::Identity();
  bool edges = false;  ///< creases are drawn as lines, as on a polyhedron
  float gloss = 0.35f;
};

/// @pre the mesh has vertices, not all in one point.
MeshPiece meshPiece(const geometry::Mesh& mesh, const Eigen::Matrix3d& R_BM, const Eigen::Vector3d& origin_B);

using Piece = std::variant<EllipsoidPiece, FrustumPiece, BoxPiece, TubePiece, MeshPiece>;

/// Line on a surface (an edge, a ring, a meridian), or a string by itself. A part that is hardly wider than its
/// lines in the picture is drawn without them. `width` is in ordinary lines.
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

/// Returns the piece's farthest point in a direction. @pre direction_B is not zero.
Eigen::Vector3d supportPoint(const Piece& piece, const Eigen::Vector3d& direction_B);

/// Returns the second of the piece's three extents, m: a rod's thickness, a plate's width.
double thickness(const Piece& piece);

/// Returns how far out a point lies: 1 on the piece's surface, less inside, infinite if the piece is too thin to
/// hide anything. A mesh counts as the solid between its tangent planes.
double gauge(const Piece& piece, const Eigen::Vector3d& p_B);

/// Place of body axes B in the picture V: a rotation, a scale in picture lengths per metre, and B's origin.
struct Placement {
  Eigen::Matrix3d R_VB;
  double scale;
  Eigen::Vector3d origin_V = Eigen::Vector3d::Zero();
};

void addFigure(draw::DrawList& list, const Figure& figure, const Placement& place, const Palette& colors,
               double lineWidth_px);

}  // namespace poinsot::stage
