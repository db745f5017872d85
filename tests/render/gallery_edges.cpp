// SPDX-License-Identifier: Apache-2.0
#include "gallery_edges.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "edge_error.h"
#include "support/gallery_scenes.h"

namespace poinsot::render {
namespace {

constexpr int kSamples = 16;  // along a pixel's side
// A quarter of the pixels of a film. The fewer pixels, the thinner the lines, and the more of the edge pixels hold
// several edges, which are the hard ones.
constexpr glm::ivec2 kSize{960, 540};

/// A scene that is not as good, and what is let pass: what was measured (docs/performance.md) and a twentieth.
struct Known {
  std::string_view scene;
  double most;
};

// A pixel keeps two edges, and takes them to lie across one another: what is seen past the first is dimmed as if
// the other had no part in it. So paper shines through where one edge lies along another.
constexpr Known kKnown[] = {
    // A line is thinner than a pixel and marks the outline of its own solid: half of it hides what the solid
    // covers.
    // Where a flat end is seen edge-on there are three or four edges to a pixel, and the farther ones are lost.
    {"displaced_axis", 4.1},
    {"frisbee", 3.1},
    {"heavy_top", 2.45},
    {"l_plate", 3.65},
    {"sleeping_top", 2.95},
    {"stroboscope", 2.65},
    {"t_handle", 4.45},
    {"wing_nut", 2.25},
    // An arrow lies along a rod.
    {"thrown_baton", 2.2},
    // A path runs along itself, lap by lap.
    {"dumbbell", 4.4},
    {"football", 2.6},
    {"football_two_views", 2.85},
    {"toutatis", 2.95},
};

}  // namespace

GalleryEdges::GalleryEdges(std::string scene)
    : name_(std::move(scene)),
      stage_(galleryScene(name_)),
      context_(gl::openContext(gl::Backend::kOsMesa)),
      renderer_(*context_) {}

double GalleryEdges::limit() const {
  const auto found = std::ranges::find(kKnown, name_, &Known::scene);
  return found == std::end(kKnown) ? kMost : found->most;
}

double GalleryEdges::worstMean(double filmTime_s) {
  const draw::Picture picture = stage_.compose(filmTime_s, kSize);
  const std::string name = fmt::format("{}, {:.2f} s", name_, filmTime_s);
  double worst = 0;
  for (std::size_t i = 0; i < picture.panels.size(); ++i)
    worst = std::max(worst, meanOf(picture.panels[i].list, fmt::format("{}, view {}", name, i + 1)));
  const bool flat = !picture.areas.empty() || !picture.strokes.empty();
  return flat ? std::max(worst, meanOfFlat(picture, name + ", flat")) : worst;
}

double GalleryEdges::meanOf(draw::DrawList view, const std::string& name) {
  view.texts.clear();
  const glm::ivec2 size(view.camera.size_px);
  return edgeError(renderer_.render(view, {size.x, size.y}), finePicture(renderer_, view, kSamples), name).mean;
}

double GalleryEdges::meanOfFlat(draw::Picture picture, const std::string& name) {
  picture.panels.clear();
  picture.texts.clear();
  return edgeError(renderer_.render(picture), fineFlatPicture(renderer_, picture, kSamples), name).mean;
}

}  // namespace poinsot::render
