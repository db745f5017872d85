// SPDX-License-Identifier: Apache-2.0
#include "stage/body/hollow_box_mesh.h"

#include <array>
#include <map>
#include <vector>

#include "core/expect.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;
using Place = std::array<int, 3>;

constexpr double kWindow = 0.6;  // width of the window, as a fraction of the cavity's width

/// Box that planes divide into 5 x 5 x 3 cells, each full or empty. The surface of the mesh lies between full and
/// empty cells.
class Cells {
 public:
  Cells(const Vector3d& edges, double wall) {
    for (int axis = 0; axis < 3; ++axis) {
      const double outer = 0.5 * edges[axis], inner = outer - wall, window = kWindow * inner;
      if (axis < 2)
        planes_[axis] = {-outer, -inner, -window, window, inner, outer};
      else
        planes_[axis] = {-outer, -inner, inner, outer};
    }
  }

  geometry::Mesh surface() {
    for (int x = 0; x < 5; ++x)
      for (int y = 0; y < 5; ++y)
        for (int z = 0; z < 3; ++z)
          if (full({x, y, z})) addFaces({x, y, z});
    return std::move(mesh_);
  }

 private:
  static bool full(const Place& cell) {
    const auto [x, y, z] = cell;
    if (x < 0 || y < 0 || z < 0 || x > 4 || y > 4 || z > 2) return false;
    const bool wall = x == 0 || x == 4 || y == 0 || y == 4;
    const bool window = x == 2 && y == 2 && z == 2;
    return wall || (z != 1 && !window);
  }

  void addFaces(const Place& cell) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1}) {
        Place beyond = cell;
        beyond[axis] += side == 1 ? 1 : -1;
        if (!full(beyond)) addFace(cell, axis, side);
      }
  }

  // Adds a face. The corners run counter-clockwise as seen from outside.
  void addFace(const Place& cell, std::size_t axis, int side) {
    std::array<std::uint32_t, 4> corners{};
    const std::array<std::array<int, 2>, 4> around{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    for (std::size_t i = 0; i < 4; ++i) {
      Place place = cell;
      place[axis] += side;
      place[(axis + 1) % 3] += around[i][side == 1 ? 0 : 1];
      place[(axis + 2) % 3] += around[i][side == 1 ? 1 : 0];
      corners[i] = vertex(place);
    }
    mesh_.triangles.push_back({corners[0], corners[1], corners[2]});
    mesh_.triangles.push_back({corners[0], corners[2], corners[3]});
  }

  std::uint32_t vertex(const Place& place) {
    const auto [entry, isNew] = known_.try_emplace(place, static_cast<std::uint32_t>(mesh_.vertices_M.size()));
    if (isNew) mesh_.vertices_M.emplace_back(plane(0, place), plane(1, place), plane(2, place));
    return entry->second;
  }
  double plane(std::size_t axis, const Place& place) const {
    return planes_[axis].at(static_cast<std::size_t>(place[axis]));
  }

  std::array<std::vector<double>, 3> planes_;
  std::map<Place, std::uint32_t> known_;
  geometry::Mesh mesh_;
};

}  // namespace

geometry::Mesh hollowBoxMesh(const Vector3d& edges, double wall) {
  POINSOT_EXPECT(wall > 0 && 2 * wall < edges.minCoeff());
  return Cells(edges, wall).surface();
}

}  // namespace poinsot::stage
