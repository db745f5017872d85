// SPDX-License-Identifier: Apache-2.0
#include "render/mesh_resolver.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <span>

#include "render/pixel_fragment.h"

namespace poinsot::render {
namespace {

using glm::dvec3;

// Least coverage at which a pixel counts as filled, as in emit.glsl.
constexpr double kWhole = 0.998;
// Smallest gap in depth between a near and a far surface, as a multiple of the pixel size.
constexpr double kGap_px = 1;
// Cosine of 11 degrees. Surfaces whose normals differ by a smaller angle are shaded as one.
constexpr float kSameNormal = 0.98f;

/// Face that faces the eye and touches a marked pixel. `pixel` is the index of the pixel among the marked pixels.
struct Reach {
  std::uint32_t pixel, mesh, face;
};

struct Extent {
  double left = std::numeric_limits<double>::infinity(), right = -left;
  void include(double x) {
    left = std::min(left, x);
    right = std::max(right, x);
  }
};

Extent extentInRow(const std::array<dvec3, 3>& t, double top) {
  Extent extent;
  for (std::size_t k = 0; k < 3; ++k) {
    const dvec3 &a = t[k], &b = t[(k + 1) % 3];
    if (a.y >= top && a.y <= top + 1) extent.include(a.x);
    for (const double y : {top, top + 1})
      if ((a.y < y) != (b.y < y)) extent.include(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
  }
  return extent;
}

class Collector {
 public:
  explicit Collector(const PixelMarks& marks) : marks_(marks) {}

  void add(const ScreenMesh& screen, std::uint32_t mesh) {
    for (std::uint32_t f = 0; f < screen.front.size(); ++f)
      if (screen.front[f]) addTriangle(screen.triangle(f), mesh, f);
  }

  /// Returns the entries in pixel order. Entries of the same pixel keep their order of insertion.
  std::vector<Reach> sorted() const {
    std::vector<std::size_t> starts(marks_.count() + 1);
    for (const Reach& r : reaches_) ++starts[r.pixel + 1];
    for (std::size_t i = 1; i < starts.size(); ++i) starts[i] += starts[i - 1];
    std::vector<Reach> sorted(reaches_.size());
    for (const Reach& r : reaches_) sorted[starts[r.pixel]++] = r;
    return sorted;
  }

 private:
  void addTriangle(const std::array<dvec3, 3>& t, std::uint32_t mesh, std::uint32_t face) {
    const auto [low, high] = std::minmax({t[0].y, t[1].y, t[2].y});
    const int top = static_cast<int>(std::max(std::floor(low), 0.0));
    const int bottom = static_cast<int>(std::min(std::floor(high), marks_.size_px().y - 1.0));
    for (int row = top; row <= bottom; ++row) {
      const auto columns = marks_.columns();
      const auto begin = columns.begin() + static_cast<std::ptrdiff_t>(marks_.firstOfRow(row));
      const auto end = columns.begin() + static_cast<std::ptrdiff_t>(marks_.firstOfRow(row + 1));
      if (begin == end) continue;
      const Extent extent = extentInRow(t, row);
      for (auto at = std::lower_bound(begin, end, std::floor(extent.left)); at != end && *at <= extent.right; ++at)
        reaches_.push_back({static_cast<std::uint32_t>(at - columns.begin()), mesh, face});
    }
  }

  const PixelMarks& marks_;
  std::vector<Reach> reaches_;
};

struct Part {
  const Reach* reach;
  const PixelFragment* fragment;
  double area;
};

glm::vec3 unit(const glm::vec3& v) {
  const float length = glm::length(v);
  return length > 0 ? v / length : glm::vec3(0, 0, 1);
}

/// Collects the surfaces that one pixel contains, and merges them into a few directions. The pixel is shaded once
/// for each direction.
class FacetMixer {
 public:
  void add(const glm::vec3& normal_C, const draw::Material& material, float area) {
    Facet& facet = facetFor(normal_C, material);
    facet.normal += area * normal_C;
    facet.color += area * glm::vec4(material.color, material.gloss);
    facet.area += area;
  }

  void writeTo(ResolvedPixel& pixel) const {
    float whole = 0;
    for (std::size_t i = 0; i < used_; ++i) whole += facets_[i].area;
    for (std::size_t i = 0; i < used_; ++i) {
      pixel.normals_C[i] = glm::vec4(unit(facets_[i].normal), facets_[i].area / whole);
      pixel.materials[i] = facets_[i].color / facets_[i].area;
    }
  }

 private:
  struct Facet {
    const draw::Material* first = nullptr;
    glm::vec3 normal{0};
    glm::vec4 color{0};
    float area = 0;
  };

  // Returns the facet with the most similar normal, or a new facet if none is similar and one is free.
  Facet& facetFor(const glm::vec3& normal_C, const draw::Material& material) {
    std::size_t best = 0;
    float closest = -4;
    for (std::size_t i = 0; i < used_; ++i) {
      const float strange = facets_[i].first == &material ? 0.0f : 2.0f;
      const float likeness = glm::dot(unit(facets_[i].normal), normal_C) - strange;
      if (likeness > closest) best = i, closest = likeness;
    }
    if (closest >= kSameNormal || used_ == facets_.size()) return facets_[best];
    facets_[used_].first = &material;
    return facets_[used_++];
  }

  std::size_t used_ = 0;
  std::array<Facet, ResolvedPixel::kFacets> facets_;
};

class Resolver {
 public:
  Resolver(const std::vector<ScreenMesh>& meshes, const draw::Camera& camera) : meshes_(meshes), camera_(camera) {}

  void resolve(glm::ivec2 pixel, std::span<const Reach> reaches) {
    fragments_.clear();
    parts_.clear();
    std::vector<const Reach*> from;
    for (const Reach& r : reaches)
      if (const auto fragment = pixelFragment(meshes_[r.mesh].triangle(r.face), pixel, camera_.orthographic)) {
        fragments_.push_back(*fragment);
        from.push_back(&r);
      }
    const std::vector<double> areas = visibleAreas(fragments_);
    for (std::size_t i = 0; i < fragments_.size(); ++i)
      if (areas[i] > 0) parts_.push_back({from[i], &fragments_[i], areas[i]});
    std::stable_sort(parts_.begin(), parts_.end(),
                     [](const Part& a, const Part& b) { return a.fragment->near < b.fragment->near; });
    const std::size_t split = nearParts();
    const std::span<const Part> all(parts_);
    const double nearArea = emit(pixel, all.first(split), 1);
    if (nearArea < kWhole) emit(pixel, all.subspan(split), 1 - nearArea);
  }

  ResolvedPixels take() { return std::move(result_); }

 private:
  // Returns how many parts belong to the near surface. The near surface ends at the first gap in depth.
  std::size_t nearParts() const {
    double reached = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const PixelFragment& f = *parts_[i].fragment;
      if (i > 0 && f.near > reached + kGap_px * pixelSize(camera_, reached)) return i;
      reached = std::max(reached, f.far);
    }
    return parts_.size();
  }

  glm::vec3 normal_C(const Part& part) const {
    const ScreenMesh& screen = meshes_[part.reach->mesh];
    const auto& corners = screen.topology->triangles[part.reach->face];
    glm::vec3 normal_M(0);
    for (int k = 0; k < 3; ++k)
      normal_M += static_cast<float>(part.fragment->weights[k]) *
                  screen.topology->corners[corners[static_cast<std::size_t>(k)]].normal_M;
    return unit(screen.normals_C * normal_M);
  }

  // Adds the parts to the result as one pixel, and returns the sum of their areas.
  // @param room  area of the pixel that nearer parts leave free
  double emit(glm::ivec2 at, std::span<const Part> parts, double room) {
    double area = 0, depth = 0;
    FacetMixer mixer;
    for (const Part& p : parts) {
      area += p.area;
      depth += p.area * p.fragment->depth;
      mixer.add(normal_C(p), meshes_[p.reach->mesh].mesh->material, static_cast<float>(p.area));
    }
    if (area <= 0) return 0;
    const double coverage = std::min(area / room, 1.0);
    ResolvedPixel pixel;
    pixel.place = glm::dvec4(glm::dvec2(at) + 0.5, coverage, depth / area);
    mixer.writeTo(pixel);
    pixel.solid = static_cast<float>(parts.front().reach->mesh);
    (coverage < kWhole ? result_.partial : result_.full).push_back(pixel);
    return area;
  }

  const std::vector<ScreenMesh>& meshes_;
  const draw::Camera& camera_;
  std::vector<PixelFragment> fragments_;
  std::vector<Part> parts_;
  ResolvedPixels result_;
};

}  // namespace

ResolvedPixels resolveMeshes(const std::vector<ScreenMesh>& meshes, const PixelMarks& marks,
                             const draw::Camera& camera) {
  Collector collector(marks);
  for (std::uint32_t i = 0; i < meshes.size(); ++i) collector.add(meshes[i], i);
  const std::vector<Reach> reaches = collector.sorted();
  Resolver resolver(meshes, camera);
  int row = 0;
  for (std::size_t begin = 0, end = 0; begin < reaches.size(); begin = end) {
    const std::uint32_t pixel = reaches[begin].pixel;
    while (end < reaches.size() && reaches[end].pixel == pixel) ++end;
    while (marks.firstOfRow(row + 1) <= pixel) ++row;
    resolver.resolve({marks.columns()[pixel], row}, std::span(reaches).subspan(begin, end - begin));
  }
  return resolver.take();
}

}  // namespace poinsot::render
