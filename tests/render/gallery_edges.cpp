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

// A pixel keeps two edges; what is behind is dimmed by each, and of a third nothing is left.
constexpr Known kKnown[] = {
    // A flat end or a thin side is seen edge-on: the lines on both of its outlines, and the solid itself.
    {"displaced_axis", 2.35},
    {"stroboscope", 2.5},
    {"t_handle", 4.0},
    // A path runs along itself, lap by lap.
    {"dumbbell", 2.15},
    {"toutatis", 2.45},
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
