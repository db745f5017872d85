// SPDX-License-Identifier: Apache-2.0
#include "render/mesh_edge_lines.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace poinsot::render {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kSoftEdge_px = 1;
// Limit on how steeply the depth of a face may grow, in pixel sizes per pixel. The line on an edge is moved in
// front of the adjacent faces by a distance proportional to their steepness. Without the limit, a face seen almost
// edge-on would move its line in front of everything.
constexpr double kSteepest = 40;
// Largest depth error of a straight piece of a line, as a multiple of the pixel size.
constexpr double kDepthError = 0.1;

// Returns how much the depth (distance along the view) of a triangle changes from one pixel to the next. The
// calculation uses that 1 / depth is linear in the picture; with parallel rays the depth itself is linear.
double steepness(const std::array<dvec3, 3>& t, bool parallel) {
  const dvec2 u = dvec2(t[1] - t[0]), v = dvec2(t[2] - t[0]);
  const auto linear = [&](double depth) { return parallel ? depth : 1 / depth; };
  const double q0 = linear(t[0].z), du = linear(t[1].z) - q0, dv = linear(t[2].z) - q0,
               area = u.x * v.y - u.y * v.x;
  const dvec2 gradient = dvec2(du * v.y - dv * u.y, dv * u.x - du * v.x) / area;
  return parallel ? glm::length(gradient) : glm::length(gradient) * t[0].z * t[0].z;
}

class LineMaker {
 public:
  LineMaker(const draw::Camera& camera, const ScreenMesh& screen) : camera_(camera), screen_(screen) {
    line_.width_px = screen.mesh->edge_px;
    line_.material = {screen.mesh->edgeColor, 0};
  }

  void add(const EdgeChain& chain) {
    bool whole = chain.vertices.front() == chain.vertices.back();
    for (std::size_t i = 0; i < chain.edges.size(); ++i) {
      const MeshEdge& edge = screen_.topology->edges[chain.edges[i]];
      if (screen_.isFront(edge)) {
        addPiece(chain.vertices[i], chain.vertices[i + 1], lift(edge));
      } else {
        whole = false;
        finish();
      }
    }
    if (whole) {
      line_.points_V.pop_back();
      line_.closed = true;
    }
    finish();
  }

  std::vector<draw::Curve> take() { return std::move(lines_); }

 private:
  // Returns the distance by which a line is moved towards the eye, so that adjacent faces hide no half of it.
  double lift(const MeshEdge& edge) const {
    const double pixel = pixelSize(camera_, screen_.vertices[edge.from].z);
    double steepest = 0;
    for (const std::uint32_t face : {edge.left, edge.right})
      if (screen_.isFront(face))
        steepest = std::max(steepest, steepness(screen_.triangle(face), camera_.orthographic));
    const double across_px = 0.5 * static_cast<double>(screen_.mesh->edge_px) + kSoftEdge_px;
    return across_px * (std::min(steepest, kSteepest * pixel) + 0.5 * pixel);
  }

  // Adds an edge, divided into pieces along which the depth is nearly linear, as curve.vert assumes.
  void addPiece(std::uint32_t from, std::uint32_t to, double lift) {
    const double a = screen_.vertices[from].z, b = screen_.vertices[to].z, nearest = std::min(a, b);
    const double longest = 2 * std::sqrt(kDepthError * pixelSize(camera_, nearest) * nearest);
    const int pieces = std::max(static_cast<int>(std::ceil(std::abs(b - a) / longest)), 1);
    for (int i = line_.points_V.empty() ? 0 : 1; i <= pieces; ++i) {
      const float s = static_cast<float>(i) / static_cast<float>(pieces);
      line_.points_V.push_back(lifted(glm::mix(point_V(from), point_V(to), s), lift));
    }
  }

  glm::vec3 point_V(std::uint32_t vertex) const {
    return screen_.mesh->origin_V + screen_.mesh->axes_V * screen_.mesh->mesh->vertices_M[vertex];
  }

  // Moves a point towards the eye. Its position in the picture does not change.
  glm::vec3 lifted(glm::vec3 p_V, double lift) const {
    const float depth = depthOf(camera_, p_V),
                share = std::min(static_cast<float>(lift) / (depth - camera_.near), 0.9f);
    const glm::vec3 toEye_V = camera_.orthographic ? depth * camera_.R_VC[2] : camera_.eye_V - p_V;
    return glm::mix(p_V, p_V + toEye_V * ((depth - camera_.near) / depth), share);
  }

  void finish() {
    if (line_.points_V.size() > 1) lines_.push_back(line_);
    line_.points_V.clear();
    line_.closed = false;
  }

  const draw::Camera& camera_;
  const ScreenMesh& screen_;
  draw::Curve line_;
  std::vector<draw::Curve> lines_;
};

}  // namespace

std::vector<draw::Curve> meshEdgeLines(const draw::Camera& camera, const ScreenMesh& screen) {
  if (screen.mesh->edge_px <= 0 || screen.bounds.empty()) return {};
  LineMaker maker(camera, screen);
  for (const EdgeChain& chain : screen.topology->chains) maker.add(chain);
  return maker.take();
}

}  // namespace poinsot::render
