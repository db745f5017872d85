// SPDX-License-Identifier: Apache-2.0
#include "gallery_edges.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "edge_error.h"
#include "support/gallery_scenes.h"

namespace poinsot::render {
namespace {

constexpr int kSamples = 16;  // along a pixel's side

}  // namespace

GalleryEdges::GalleryEdges(std::string scene, glm::ivec2 size)
    : name_(std::move(scene)),
      size_(size),
      stage_(galleryScene(name_)),
      context_(gl::openContext(gl::Backend::kAuto)),
      renderer_(*context_) {}

double GalleryEdges::worstMean(double filmTime_s) {
  const draw::Picture picture = stage_.compose(filmTime_s, size_);
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
