// SPDX-License-Identifier: Apache-2.0
#include "stage/body/figure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/expect.h"
#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr float kLift = 0.02f;  // distance of lines in front of their surface, in picture lengths
constexpr double kStep = 0.2;   // longest segment of a line, in picture lengths

Vector3d rimPoint(const Vector3d& centre, const Vector3d& normal, double radius, const Vector3d& direction) {
  const Vector3d across = direction - direction.dot(normal) * normal;
  const double length = across.norm();
  return length > 1e-12 * direction.norm() ? Vector3d(centre + radius / length * across) : centre;
}

template <typename Points>
Vector3d farthestOf(const Points& points, const Vector3d& direction) {
  return *std::ranges::max_element(points, {}, [&](const Vector3d& p) { return p.dot(direction); });
}

struct Support {
  const Vector3d& direction;

  Vector3d operator()(const EllipsoidPiece& e) const {
    const Vector3d onSphere = e.semiAxes_B.transpose() * direction;
    const double length = onSphere.norm();
    return length > 0 ? Vector3d(e.centre_B + e.semiAxes_B * (onSphere / length)) : e.centre_B;
  }
  Vector3d operator()(const FrustumPiece& f) const {
    const Vector3d normal = (f.to_B - f.from_B).normalized();
    return farthestOf(std::vector{rimPoint(f.from_B, normal, f.fromRadius, direction),
                                  rimPoint(f.to_B, normal, f.toRadius, direction)},
                      direction);
  }
  Vector3d operator()(const BoxPiece& b) const {
    Vector3d corner = b.centre_B;
    for (int i = 0; i < 3; ++i)
      corner += std::copysign(1, b.halfAxes_B.col(i).dot(direction)) * b.halfAxes_B.col(i);
    return corner;
  }
  // Treats the tube as a ball moved along the curve, so the flat ends of an open tube count as round.
  Vector3d operator()(const TubePiece& t) const {
    return farthestOf(t.points_B, direction) + t.radius * direction.normalized();
  }
  Vector3d operator()(const MeshPiece& m) const {
    const glm::vec3 along = toPicture(Vector3d((m.axes_B.transpose() * direction).normalized()));
    const auto farthest = std::ranges::max_element(
        m.mesh->vertices_M, {}, [&](const glm::vec3& v) { return v.x * along.x + v.y * along.y + v.z * along.z; });
    return m.centre_B + m.axes_B * fromPicture(*farthest);
  }
};

struct Gauge {
  const Vector3d& p_B;

  double operator()(const EllipsoidPiece& e) const { return inAxes(e.semiAxes_B, e.centre_B).norm(); }
  double operator()(const BoxPiece& b) const { return inAxes(b.halfAxes_B, b.centre_B).cwiseAbs().maxCoeff(); }
  double operator()(const FrustumPiece& f) const {
    const Vector3d axis = 0.5 * (f.to_B - f.from_B), out = p_B - 0.5 * (f.from_B + f.to_B);
    const double along = out.dot(axis) / axis.squaredNorm(), across = (out - along * axis).norm();
    if (f.paint == Paint::kRod) return std::numeric_limits<double>::infinity();
    const double share = 0.5 * (1 + std::clamp(along, -1.0, 1.0));
    const double least = 1e-3 * std::max(f.fromRadius, f.toRadius);
    return std::max(across / std::max(std::lerp(f.fromRadius, f.toRadius, share), least), std::abs(along));
  }
  double operator()(const TubePiece&) const { return std::numeric_limits<double>::infinity(); }
  double operator()(const MeshPiece& m) const {
    const Vector3d p_M = inAxes(m.axes_B, m.centre_B);
    double farthest = 0;
    for (const Eigen::Vector4d& plane : m.tangents_M)
      farthest = std::max(farthest, plane.head<3>().dot(p_M) / plane.w());
    return farthest;
  }

 private:
  Vector3d inAxes(const Matrix3d& axes, const Vector3d& centre) const { return axes.inverse() * (p_B - centre); }
};

double middleOf(Vector3d extents) {
  std::ranges::sort(extents);
  return extents[1];
}

struct Thickness {
  double operator()(const EllipsoidPiece& e) const { return 2 * middleOf(e.semiAxes_B.colwise().norm()); }
  double operator()(const FrustumPiece& f) const { return 2 * std::max(f.fromRadius, f.toRadius); }
  double operator()(const BoxPiece& b) const { return 2 * middleOf(b.halfAxes_B.colwise().norm()); }
  double operator()(const TubePiece& t) const { return 2 * t.radius; }
  double operator()(const MeshPiece& m) const {
    Vector3d extents;
    for (int i = 0; i < 3; ++i) {
      const Vector3d axis_B = m.axes_B.col(i).normalized();
      extents[i] = axis_B.dot(Support{axis_B}(m)-Support{-axis_B}(m));
    }
    return middleOf(extents);
  }
};

struct Draw {
  draw::DrawList& list;
  const Placement& place;
  const Palette& colors;
  double lineWidth_px;

  glm::vec3 point(const Vector3d& p_B) const {
    return toPicture(Vector3d(place.origin_V + place.scale * (place.R_VB * p_B)));
  }
  glm::mat3 axes(const Matrix3d& A_B) const { return toPicture(Matrix3d(place.scale * place.R_VB * A_B)); }
  float length(double metres) const { return static_cast<float>(place.scale * metres); }
  const draw::Color& color(Paint paint) const { return paint == Paint::kRod ? colors.rod : colors.body; }

  draw::Curve curve(const std::vector<Vector3d>& points_B, bool closed) const {
    draw::Curve curve;
    for (const Vector3d& p : points_B) curve.points_V.push_back(point(p));
    curve.closed = closed;
    return curve;
  }

  void operator()(const EllipsoidPiece& e) const {
    list.ellipsoids.push_back({point(e.centre_B),
                               axes(e.semiAxes_B),
                               {color(e.paint), 0.5f},
                               colors.bodyEdge,
                               e.marked ? static_cast<float>(lineWidth_px) : 0.0f});
  }
  void operator()(const FrustumPiece& f) const {
    list.frustums.push_back(
        {point(f.from_B), point(f.to_B), length(f.fromRadius), length(f.toRadius), {color(f.paint), 0.35f}});
  }
  void operator()(const BoxPiece& b) const {
    list.boxes.push_back({point(b.centre_B), axes(b.halfAxes_B), {colors.body, 0.15f}});
  }
  void operator()(const TubePiece& t) const {
    draw::Curve tube = curve(t.points_B, t.closed);
    tube.radius_V = length(t.radius);
    tube.material.color = colors.body;
    list.curves.push_back(std::move(tube));
  }
  void operator()(const MeshPiece& m) const {
    draw::Mesh mesh;
    mesh.mesh = m.mesh;
    mesh.origin_V = point(m.centre_B);
    mesh.axes_V = axes(m.axes_B);
    mesh.material = {colors.body, m.gloss};
    mesh.edgeColor = colors.bodyEdge;
    mesh.edge_px = m.edges ? static_cast<float>(lineWidth_px) : 0.0f;
    list.meshes.push_back(std::move(mesh));
  }
  // Divides a line into short segments. The renderer interpolates a curve's depth along the picture, where depth
  // is not linear, so long segments would sink into their surface.
  std::vector<Vector3d> inShortSteps(const std::vector<Vector3d>& points_B) const {
    std::vector<Vector3d> dense{points_B.front()};
    for (std::size_t i = 1; i < points_B.size(); ++i) {
      const Vector3d &from = points_B[i - 1], &to = points_B[i];
      const int steps = std::max(1, static_cast<int>(std::ceil(place.scale * (to - from).norm() / kStep)));
      for (int k = 1; k <= steps; ++k) dense.push_back(k == steps ? to : Vector3d(from + (to - from) * k / steps));
    }
    return dense;
  }

  /// Returns true if a line would hide the outline of its part. The renderer stores two edges per pixel. On a part
  /// of only a few pixels, the edges of the line would replace those of the part.
  bool tooThinFor(const Mark& mark) const {
    const double least_px = std::max(6.0, 3 * lineWidth_px);
    const double unit_px = list.camera.scale_px(depthOf(list.camera, toPicture(place.origin_V)));
    return mark.part_m * place.scale * unit_px < least_px;
  }

  void operator()(const Mark& mark) const {
    if (tooThinFor(mark)) return;
    draw::Curve line = curve(mark.closed ? mark.points_B : inShortSteps(mark.points_B), mark.closed);
    line.width_px = static_cast<float>(mark.width * lineWidth_px);
    line.lift_V = kLift;
    line.material.color = colors.bodyEdge;
    list.curves.push_back(std::move(line));
  }
};

std::vector<Eigen::Vector4d> tangents(const MeshPiece& unturned) {
  std::vector<Eigen::Vector4d> planes;
  for (const Vector3d& n : cubeDirections()) {
    Eigen::Vector4d& plane = planes.emplace_back();
    plane << n, std::max(n.dot(Support{n}(unturned)), 1e-3);  // avoids a division by 0 for a flat mesh
  }
  return planes;
}

}  // namespace

std::vector<Vector3d> cubeDirections() {
  std::vector<Vector3d> directions;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (x != 0 || y != 0 || z != 0) directions.push_back(Vector3d(x, y, z).normalized());
  return directions;
}

MeshPiece meshPiece(const geometry::Mesh& mesh, const Matrix3d& R_BM, const Vector3d& origin_B) {
  Vector3d low = mesh.vertices_M.at(0), high = low;
  for (const Vector3d& v : mesh.vertices_M) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  const Vector3d middle = 0.5 * (low + high);
  const double size = 0.5 * (high - low).maxCoeff();
  POINSOT_EXPECT(size > 0);
  const auto unit = std::make_shared<draw::TriangleMesh>();
  for (const Vector3d& v : mesh.vertices_M) unit->vertices_M.push_back(toPicture(Vector3d((v - middle) / size)));
  unit->triangles = mesh.triangles;
  MeshPiece piece;
  piece.mesh = unit;
  piece.tangents_M = tangents(piece);
  piece.centre_B = origin_B + R_BM * middle;
  piece.axes_B = size * R_BM;
  return piece;
}

Vector3d supportPoint(const Piece& piece, const Vector3d& direction_B) {
  return std::visit(Support{direction_B}, piece);
}

double thickness(const Piece& piece) { return std::visit(Thickness{}, piece); }

double gauge(const Piece& piece, const Vector3d& p_B) { return std::visit(Gauge{p_B}, piece); }

void addFigure(draw::DrawList& list, const Figure& figure, const Placement& place, const Palette& colors,
               double lineWidth_px) {
  const Draw draw{list, place, colors, lineWidth_px};
  for (const Piece& piece : figure.pieces) std::visit(draw, piece);
  for (const Mark& mark : figure.marks) draw(mark);
}

}  // namespace poinsot::stage
