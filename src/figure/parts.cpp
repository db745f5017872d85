// SPDX-License-Identifier: Apache-2.0
#include "figure/parts.h"

namespace poinsot::figure {
namespace {

void keepHalos(std::vector<draw::Text>& texts) {
  std::erase_if(texts, [](const draw::Text& text) { return !text.halo || text.halo_px <= 0; });
  for (draw::Text& text : texts) text.color = *text.halo;
}

}  // namespace

draw::Picture surfacesOf(const draw::Picture& picture) {
  draw::Picture surfaces = withoutType(picture);
  surfaces.areas.clear();
  surfaces.strokes.clear();
  for (draw::Panel& panel : surfaces.panels)
    std::erase_if(panel.list.curves, [](const draw::Curve& curve) { return curve.radius_V <= 0; });
  return surfaces;
}

draw::Picture withoutType(const draw::Picture& picture) {
  draw::Picture rest = picture;
  keepHalos(rest.texts);
  for (draw::Panel& panel : rest.panels) keepHalos(panel.list.texts);
  return rest;
}

std::vector<PanelCurves> curvesOf(const draw::Picture& picture) {
  std::vector<PanelCurves> all;
  for (const draw::Panel& panel : picture.panels)
    all.push_back({panel.origin_px, glm::ivec2(panel.list.camera.size_px), seenLines(panel.list)});
  return all;
}

std::vector<draw::Text> labelsOf(const draw::Picture& picture) {
  std::vector<draw::Text> labels = picture.texts;
  for (const draw::Panel& panel : picture.panels)
    for (draw::Text text : panel.list.texts) {
      text.baseline_px += panel.origin_px;
      labels.push_back(std::move(text));
    }
  return labels;
}

}  // namespace poinsot::figure
