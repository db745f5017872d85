// SPDX-License-Identifier: Apache-2.0
#include "fine_picture.h"

#include <algorithm>
#include <cstdlib>
#include <functional>

namespace poinsot::render {
namespace {

constexpr int kStep = 2;        // of 255; neighbouring samples that differ by more make an edge
constexpr int kPart_px = 2048;  // side of a part, whose buffers take 250 MB

image::PixelSize sizeOf(const draw::DrawList& list) {
  return {static_cast<int>(list.camera.size_px.x), static_cast<int>(list.camera.size_px.y)};
}

bool differ(const std::uint8_t* a, const std::uint8_t* b) {
  return std::abs(a[0] - b[0]) > kStep || std::abs(a[1] - b[1]) > kStep || std::abs(a[2] - b[2]) > kStep;
}

// Returns whether an edge runs through the pixel whose samples begin at (left, top).
bool holdsEdge(const image::Image& samples, int left, int top, int n) {
  for (int y = top; y < top + n; ++y)
    for (int x = left; x < left + n; ++x) {
      const std::uint8_t* here = samples.at(x, y);
      if (x + 1 < left + n && differ(here, samples.at(x + 1, y))) return true;
      if (y + 1 < top + n && differ(here, samples.at(x, y + 1))) return true;
    }
  return false;
}

glm::dvec3 meanLight(const image::Image& samples, int left, int top, int n) {
  glm::dvec3 sum(0);
  for (int y = top; y < top + n; ++y)
    for (int x = left; x < left + n; ++x)
      for (int c = 0; c < 3; ++c) sum[c] += static_cast<double>(draw::linearFromSrgb8(samples.at(x, y)[c]));
  return sum / static_cast<double>(n * n);
}

/// Draws a part of the large picture, from the corner `from_px` on.
using DrawPart = std::function<image::Image(glm::ivec2 from_px, image::PixelSize part)>;

void addPart(const image::Image& samples, glm::ivec2 from_px, int n, FinePicture& fine) {
  for (int y = 0; y < samples.size.height / n; ++y)
    for (int x = 0; x < samples.size.width / n; ++x) {
      const int px = from_px.x / n + x, py = from_px.y / n + y;
      const glm::dvec3 light = meanLight(samples, n * x, n * y, n);
      for (int c = 0; c < 3; ++c) fine.mean.at(px, py)[c] = draw::srgb8FromLinear(static_cast<float>(light[c]));
      fine.edge[static_cast<std::size_t>(py * fine.mean.size.width + px)] = holdsEdge(samples, n * x, n * y, n);
    }
}

FinePicture ofParts(image::PixelSize size, int n, const DrawPart& draw) {
  FinePicture fine{image::Image(size, 3), std::vector<bool>(static_cast<std::size_t>(size.width * size.height))};
  const int side = kPart_px / n * n;
  for (int top = 0; top < n * size.height; top += side)
    for (int left = 0; left < n * size.width; left += side) {
      const image::PixelSize part{std::min(side, n * size.width - left), std::min(side, n * size.height - top)};
      addPart(draw({left, top}, part), {left, top}, n, fine);
    }
  return fine;
}

void magnify(std::vector<glm::vec2>& points_px, int n, glm::ivec2 from_px) {
  for (glm::vec2& p : points_px) p = static_cast<float>(n) * p - glm::vec2(from_px);
}

}  // namespace

draw::DrawList magnified(const draw::DrawList& list, int n, glm::ivec2 from_px, image::PixelSize size) {
  const auto factor = static_cast<float>(n);
  draw::DrawList large = list;
  large.texts.clear();
  draw::Camera& camera = large.camera;
  // The focal length in pixels follows the height of the picture, which is the height of a part here.
  const float part = static_cast<float>(size.height) / (factor * list.camera.size_px.y);
  camera.tanHalfFovY *= part;
  camera.halfHeight_V *= part;
  camera.size_px = {size.width, size.height};
  camera.centre_px = factor * list.camera.centre_px - glm::vec2(from_px);
  for (draw::Ellipsoid& e : large.ellipsoids) e.marking_px *= factor;
  for (draw::Mesh& m : large.meshes) m.edge_px *= factor;
  for (draw::Curve& c : large.curves) c.width_px *= factor;
  for (draw::GlassEllipsoid& e : large.glassEllipsoids)
    if (e.graticule) e.graticule->width_px *= factor;
  for (draw::GlassCone& c : large.glassCones) c.lineWidth_px *= factor;
  for (draw::GlassPolygon& p : large.glassPolygons) p.lineWidth_px *= factor;
  for (draw::GridPlane& p : large.planes) p.lineWidth_px *= factor;
  return large;
}

FinePicture finePicture(Renderer& renderer, const draw::DrawList& list, int n) {
  return ofParts(sizeOf(list), n, [&](glm::ivec2 from_px, image::PixelSize part) {
    return renderer.render(magnified(list, n, from_px, part), part);
  });
}

draw::Picture magnifiedFlat(const draw::Picture& picture, int n, glm::ivec2 from_px, image::PixelSize size) {
  draw::Picture large{{size.width, size.height}, picture.background, {}, picture.areas, picture.strokes, {}};
  const auto factor = static_cast<float>(n);
  for (draw::Area& area : large.areas) magnify(area.points_px, n, from_px);
  for (draw::Stroke& stroke : large.strokes) {
    magnify(stroke.points_px, n, from_px);
    stroke.width_px *= factor;
    stroke.dash_px *= factor;
  }
  return large;
}

FinePicture fineFlatPicture(Renderer& renderer, const draw::Picture& picture, int n) {
  return ofParts({picture.size_px.x, picture.size_px.y}, n, [&](glm::ivec2 from_px, image::PixelSize part) {
    return renderer.render(magnifiedFlat(picture, n, from_px, part));
  });
}

}  // namespace poinsot::render
