// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh_writers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace poinsot::geometry {
namespace {

template <typename T>
std::string bytesOf(T value, std::endian order = std::endian::little) {
  auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if (order != std::endian::native) std::ranges::reverse(bytes);
  return {bytes.begin(), bytes.end()};
}

std::string words(const Eigen::Vector3d& v) { return fmt::format("{:.17g} {:.17g} {:.17g}", v[0], v[1], v[2]); }

}  // namespace

std::string asObj(const Mesh& mesh) {
  std::string text = "# a mesh\no body\n";
  for (const Eigen::Vector3d& v : mesh.vertices_M) text += "v " + words(v) + "\n";
  text += "vn 0 0 1\ns off\nusemtl grey\n";
  for (const auto& [a, b, c] : mesh.triangles) text += fmt::format("f {} {} {}\n", a + 1, b + 1, c + 1);
  return text;
}

std::string asAsciiStl(const Mesh& mesh) {
  std::string text = "solid body\n";
  for (const Mesh::Triangle& t : mesh.triangles) {
    text += "  facet normal 0 0 0\n    outer loop\n";
    for (const std::uint32_t i : t) text += "      vertex " + words(mesh.vertices_M[i]) + "\n";
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid body\n";
}

std::string asBinaryStl(const Mesh& mesh) {
  std::string bytes(80, ' ');
  bytes.replace(0, 5, "solid");  // as some programs begin a binary STL
  bytes += bytesOf(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Mesh::Triangle& t : mesh.triangles) {
    bytes += std::string(12, '\0');
    for (const std::uint32_t i : t)
      for (const double x : mesh.vertices_M[i]) bytes += bytesOf(static_cast<float>(x));
    bytes += std::string(2, '\0');
  }
  return bytes;
}

std::string asAsciiPly(const Mesh& mesh) {
  std::string text = fmt::format(
      "ply\nformat ascii 1.0\ncomment a mesh\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property double z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      mesh.vertices_M.size(), mesh.triangles.size());
  for (const Eigen::Vector3d& v : mesh.vertices_M) text += words(v) + "\n";
  for (const auto& [a, b, c] : mesh.triangles) text += fmt::format("3 {} {} {}\n", a, b, c);
  return text;
}

std::string asBinaryPly(const Mesh& mesh, std::endian order) {
  std::string bytes = fmt::format(
      "ply\nformat binary_{}_endian 1.0\nelement camera 2\nproperty uchar kind\nproperty list short float "
      "setting\n"
      "element vertex {}\nproperty float nx\nproperty double z\nproperty double y\nproperty double x\n"
      "property list uchar uchar tags\nelement face {}\nproperty char group\n"
      "property list uint ushort vertex_index\nend_header\n",
      order == std::endian::little ? "little" : "big", mesh.vertices_M.size(), mesh.triangles.size());
  for (int camera = 0; camera < 2; ++camera)
    bytes += bytesOf(std::uint8_t{7}) + bytesOf(std::int16_t{1}, order) + bytesOf(1.5F, order);
  for (const Eigen::Vector3d& v : mesh.vertices_M)
    bytes += bytesOf(0.5F, order) + bytesOf(v[2], order) + bytesOf(v[1], order) + bytesOf(v[0], order) +
             bytesOf(std::uint8_t{2}) + "ab";
  for (const Mesh::Triangle& t : mesh.triangles) {
    bytes += bytesOf(std::int8_t{-1}) + bytesOf(std::uint32_t{3}, order);
    for (const std::uint32_t i : t) bytes += bytesOf(static_cast<std::uint16_t>(i), order);
  }
  return bytes;
}

}  // namespace poinsot::geometry
