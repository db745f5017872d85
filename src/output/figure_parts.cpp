// SPDX-License-Identifier: Apache-2.0
#include "output/figure_parts.h"

namespace poinsot::output {

draw::Picture surfacesOf(const draw::Picture& picture) {
  draw::Picture surfaces = withoutTexts(picture);
  surfaces.areas.clear();
  surfaces.strokes.clear();
  for (draw::Panel& panel : surfaces.panels)
    std::erase_if(panel.list.curves, [](const draw::Curve& curve) { return curve.radius_W <= 0; });
  return surfaces;
}

draw::Picture withoutTexts(const draw::Picture& picture) {
  draw::Picture rest = picture;
  rest.texts.clear();
  for (draw::Panel& panel : rest.panels) panel.list.texts.clear();
  return rest;
}

std::vector<PanelCurves> curvesOf(const draw::Picture& picture) {
  std::vector<PanelCurves> all;
  for (const draw::Panel& panel : picture.panels)
    all.push_back({panel.origin_px, glm::ivec2(panel.list.camera.size_px), draw::seenLines(panel.list)});
  return all;
}

std::vector<draw::Text> labelsOf(const draw::Picture& picture) {
  std::vector<draw::Text> labels;
  for (const draw::Panel& panel : picture.panels)
    for (draw::Text text : panel.list.texts) {
      text.baseline_px += panel.origin_px;
      labels.push_back(std::move(text));
    }
  labels.insert(labels.end(), picture.texts.begin(), picture.texts.end());
  return labels;
}

}  // namespace poinsot::output
