// SPDX-License-Identifier: Apache-2.0
// Structured bindings name all fields of each struct. With a new field, this file does not compile until the
// digest includes it.
#include "draw/picture_digest.h"

#include <bit>
#include <concepts>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace poinsot::draw {
namespace {

static_assert(std::endian::native == std::endian::little, "the digest requires little-endian bytes");

// Types whose bytes determine their value: they have no padding and no pointers.
template <class T>
concept Plain = (std::is_arithmetic_v<T> && !std::same_as<T, bool>) || std::same_as<T, glm::vec2> ||
                std::same_as<T, glm::vec3> || std::same_as<T, glm::ivec2> || std::same_as<T, glm::mat3> ||
                std::same_as<T, std::array<std::uint32_t, 3>> || std::same_as<T, core::Digest>;

class Feed {
 public:
  template <class... T>
  void operator()(const T&... values) {
    (add(values), ...);
  }
  core::Digest finish() { return sum_.finish(); }

 private:
  template <Plain T>
  void add(const T& value) {
    sum_.add(std::as_bytes(std::span(&value, 1)));
  }
  void add(bool value) { add(static_cast<std::uint8_t>(value)); }
  void add(const std::string& text) {
    add(std::uint64_t{text.size()});
    sum_.add(text);
  }
  template <class T>
  void add(const std::optional<T>& value) {
    add(value.has_value());
    if (value) add(*value);
  }
  template <Plain T>
  void add(const std::vector<T>& values) {
    add(std::uint64_t{values.size()});
    sum_.add(std::as_bytes(std::span(values)));
  }
  template <class T>
  void add(const std::vector<T>& values) {
    add(std::uint64_t{values.size()});
    for (const T& value : values) add(value);
  }

  void add(const Camera& camera) {
    const auto& [eye, axes, tangent, orthographic, halfHeight, near, far, size, centre] = camera;
    (*this)(eye, axes, tangent, orthographic, halfHeight, near, far, size, centre);
  }
  void add(const Material& material) {
    const auto& [color, gloss] = material;
    (*this)(color, gloss);
  }
  void add(const Graticule& graticule) {
    const auto& [color, width, opacity, farOpacity] = graticule;
    (*this)(color, width, opacity, farOpacity);
  }
  void add(const Ellipsoid& e) {
    const auto& [centre, semiAxes, material, markingColor, marking] = e;
    (*this)(centre, semiAxes, material, markingColor, marking);
  }
  void add(const Frustum& f) {
    const auto& [from, to, fromRadius, toRadius, material] = f;
    (*this)(from, to, fromRadius, toRadius, material);
  }
  void add(const Box& box) {
    const auto& [centre, halfAxes, material] = box;
    (*this)(centre, halfAxes, material);
  }
  void add(const Curve& curve) {
    const auto& [points, closed, width, radius, lift, material] = curve;
    (*this)(points, closed, width, radius, lift, material);
  }
  void add(const GlassEllipsoid& e) {
    const auto& [centre, semiAxes, color, near, far, rim, graticule] = e;
    (*this)(centre, semiAxes, color, near, far, rim, graticule);
  }
  void add(const GlassCone& c) {
    const auto& [apex, axis, angle, height, color, near, far, rim, lineColor, lineOpacity, lineWidth] = c;
    (*this)(apex, axis, angle, height, color, near, far, rim, lineColor, lineOpacity, lineWidth);
  }
  void add(const GlassPolygon& p) {
    const auto& [corners, color, opacity, lineColor, lineOpacity, lineWidth] = p;
    (*this)(corners, color, opacity, lineColor, lineOpacity, lineWidth);
  }
  void add(const GridPlane& p) {
    const auto& [centre, u, v, spacing, color, opacity, lineColor, lineOpacity, lineWidth, shadowCentre,
                 shadowRadius, shadowOpacity] = p;
    (*this)(centre, u, v, spacing, color, opacity, lineColor, lineOpacity, lineWidth, shadowCentre, shadowRadius,
            shadowOpacity);
  }
  void add(const Text& text) {
    const auto& [tex, baseline, size, color, opacity, halo, halo_px] = text;
    (*this)(tex, baseline, size, color, opacity, halo, halo_px);
  }
  void add(const Stroke& stroke) {
    const auto& [points, closed, width, dash, color, opacity, plot] = stroke;  // plot does not change the picture
    (*this)(points, closed, width, dash, color, opacity);
  }
  void add(const Area& area) {
    const auto& [points, color, opacity] = area;
    (*this)(points, color, opacity);
  }

  core::Sha256 sum_;
};

}  // namespace

const core::Digest& PictureDigester::ofMesh(const std::shared_ptr<const TriangleMesh>& mesh) {
  std::erase_if(meshes_, [](const auto& known) { return known.second.mesh.expired(); });
  const auto known = meshes_.find(mesh.get());
  if (known != meshes_.end()) return known->second.digest;
  Feed feed;
  if (mesh) {
    const auto& [vertices, triangles] = *mesh;
    feed(vertices, triangles);
  }
  return meshes_.emplace(mesh.get(), Known{mesh, feed.finish()}).first->second.digest;
}

core::Digest PictureDigester::operator()(const Picture& picture) {
  Feed feed;
  const auto& [size, background, panels, areas, strokes, texts] = picture;
  feed(size, background, areas, strokes, texts, std::uint64_t{panels.size()});
  for (const Panel& panel : panels) {
    const auto& [origin, list] = panel;
    const auto& [camera, paper, light, ellipsoids, frustums, boxes, meshes, curves, glassEllipsoids, glassCones,
                 glassPolygons, planes, labels, points, isCutOff] = list;  // the last two are not drawn
    feed(origin, camera, paper, light, ellipsoids, frustums, boxes, curves, glassEllipsoids, glassCones,
         glassPolygons, planes, labels, std::uint64_t{meshes.size()});
    for (const Mesh& drawn : meshes) {
      const auto& [mesh, place, axes, crease, material, edgeColor, edge] = drawn;
      feed(ofMesh(mesh), place, axes, crease, material, edgeColor, edge);
    }
  }
  return feed.finish();
}

}  // namespace poinsot::draw
