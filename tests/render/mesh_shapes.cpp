// SPDX-License-Identifier: Apache-2.0
#include "mesh_shapes.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <utility>

#include "random.h"

namespace poinsot::render {
namespace {

using draw::TriangleMesh;
using glm::vec3;
using Index = std::uint32_t;

MeshPointer share(TriangleMesh mesh) { return std::make_shared<const TriangleMesh>(std::move(mesh)); }

void addQuad(TriangleMesh& mesh, Index a, Index b, Index c, Index d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

float angle(int i, int n) { return 2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(n); }

Index middle(TriangleMesh& mesh, std::map<std::pair<Index, Index>, Index>& known, Index a, Index b) {
  const auto [at, isNew] = known.try_emplace({std::min(a, b), std::max(a, b)}, 0);
  if (isNew) {
    at->second = static_cast<Index>(mesh.vertices_M.size());
    mesh.vertices_M.push_back(glm::normalize(mesh.vertices_M[a] + mesh.vertices_M[b]));
  }
  return at->second;
}

TriangleMesh subdivided(TriangleMesh mesh) {
  std::map<std::pair<Index, Index>, Index> known;
  std::vector<std::array<Index, 3>> finer;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Index ab = middle(mesh, known, a, b), bc = middle(mesh, known, b, c), ca = middle(mesh, known, c, a);
    finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  mesh.triangles = std::move(finer);
  return mesh;
}

}  // namespace

MeshPointer cubesAtAnEdge() {
  const MeshPointer one = cube();
  TriangleMesh mesh;
  for (const float side : {-0.5f, 0.5f})
    for (const vec3& v : one->vertices_M) mesh.vertices_M.push_back(0.5f * v + vec3(side, side, 0));
  const auto other = [](Index i) { return i == 0 ? Index{3} : i == 4 ? Index{7} : i + 8; };  // the shared corners
  for (const auto& [a, b, c] : one->triangles) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({other(a), other(b), other(c)});
  }
  return share(mesh);
}

MeshPointer cube() {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.vertices_M.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  addQuad(mesh, 0, 2, 3, 1);
  addQuad(mesh, 4, 5, 7, 6);
  addQuad(mesh, 0, 1, 5, 4);
  addQuad(mesh, 2, 6, 7, 3);
  addQuad(mesh, 0, 4, 6, 2);
  addQuad(mesh, 1, 3, 7, 5);
  return share(mesh);
}

MeshPointer tetrahedron() {
  return share({{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}});
}

MeshPointer icosphere(int subdivisions) {
  const float g = std::numbers::phi_v<float>;
  TriangleMesh mesh{{{-1, g, 0},
                     {1, g, 0},
                     {-1, -g, 0},
                     {1, -g, 0},
                     {0, -1, g},
                     {0, 1, g},
                     {0, -1, -g},
                     {0, 1, -g},
                     {g, 0, -1},
                     {g, 0, 1},
                     {-g, 0, -1},
                     {-g, 0, 1}},
                    {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  for (vec3& v : mesh.vertices_M) v = glm::normalize(v);
  for (int i = 0; i < subdivisions; ++i) mesh = subdivided(std::move(mesh));
  return share(mesh);
}

MeshPointer roughSphere(int subdivisions, float depth) {
  TriangleMesh mesh = *icosphere(subdivisions);
  Random random;
  for (vec3& v : mesh.vertices_M) v *= 1 - random.in(0, depth);
  return share(mesh);
}

MeshPointer torus(float tubeRadius, int around, int along) {
  TriangleMesh mesh;
  for (int i = 0; i < around; ++i) {
    const vec3 out(std::cos(angle(i, around)), std::sin(angle(i, around)), 0);
    for (int k = 0; k < along; ++k)
      mesh.vertices_M.push_back(
          out + tubeRadius * (std::cos(angle(k, along)) * out + std::sin(angle(k, along)) * vec3(0, 0, 1)));
  }
  const auto at = [&](int i, int k) { return static_cast<Index>(i % around * along + k % along); };
  for (int i = 0; i < around; ++i)
    for (int k = 0; k < along; ++k) addQuad(mesh, at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1));
  return share(mesh);
}

MeshPointer lPrism() {
  TriangleMesh mesh;
  for (const float z : {0.0f, 1.0f})
    for (const vec3 p :
         {vec3(-1, -1, z), vec3(1, -1, z), vec3(1, 0, z), vec3(0, 0, z), vec3(0, 1, z), vec3(-1, 1, z)})
      mesh.vertices_M.push_back(p);
  for (Index i = 0; i < 6; ++i) addQuad(mesh, i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6);
  addQuad(mesh, 0, 3, 2, 1);
  addQuad(mesh, 0, 5, 4, 3);
  addQuad(mesh, 6, 7, 8, 9);
  addQuad(mesh, 6, 9, 10, 11);
  return share(mesh);
}

MeshPointer hemisphere(int around, int along) {
  TriangleMesh mesh;
  for (int k = 0; k < along; ++k) {
    const float latitude = 0.25f * angle(k, along);
    for (int i = 0; i < around; ++i)
      mesh.vertices_M.emplace_back(std::cos(latitude) * std::cos(angle(i, around)),
                                   std::cos(latitude) * std::sin(angle(i, around)), std::sin(latitude));
  }
  const auto top = static_cast<Index>(mesh.vertices_M.size()), middle = top + 1;
  mesh.vertices_M.insert(mesh.vertices_M.end(), {{0, 0, 1}, {0, 0, 0}});
  const auto at = [&](int k, int i) { return static_cast<Index>(k * around + i % around); };
  for (int i = 0; i < around; ++i) {
    for (int k = 0; k + 1 < along; ++k) addQuad(mesh, at(k, i), at(k, i + 1), at(k + 1, i + 1), at(k + 1, i));
    mesh.triangles.push_back({at(along - 1, i), at(along - 1, i + 1), top});
    mesh.triangles.push_back({at(0, i + 1), at(0, i), middle});
  }
  return share(mesh);
}

}  // namespace poinsot::render
