// SPDX-License-Identifier: Apache-2.0
#include "describe/picture_words.h"

#include "core/text.h"
#include "describe/alt_sections.h"
#include "describe/alt_text.h"
#include "describe/language.h"
#include "request/sweep_cells.h"
#include "stage/stability_map.h"
#include "stage/type/sweep_label.h"
#include "text/math_setter.h"

namespace poinsot::describe {
namespace {

std::string rangeWords(const stage::SweepLabels& labels) {
  const auto plain = [](const std::string& tex) { return text::setTex(tex).plainText; };
  return say("{} from {} to {}", plain(labels.name), plain(labels.values.front()), plain(labels.values.back()));
}

/// @param scene  scene of the first cell, with its final speed
std::string gridWords(const request::SceneRequest& request, const scene::Scene& scene) {
  const request::SweepGrid grid(request);
  const auto labels = stage::sweepLabels(grid.axes, request.sweep->labels, scene);
  const std::string ranges = labels.size() == 1 ? rangeWords(labels[0])
                                                : say("{} from left to right, {} from top to bottom",
                                                      rangeWords(labels[0]), rangeWords(labels[1]));
  return say(grid.variesInstant() ? "{} pictures of one scene side by side, at several instants: {}. The first: {}"
                                  : "{} pictures of one scene side by side, at one instant: {}. The first: {}",
             grid.cells, ranges, altText(scene));
}

std::string mapWords(const scene::Scene& scene) {
  const stage::StabilityMap map(scene);
  const auto& axes = map.scale().separatrix();
  return say(
      "A map of how long the body takes from flip to flip, for every direction of L in it: a sphere of "
      "directions, from {} in dark colours at the axes {} and {}, the stable ones, to {} and more in pale "
      "ones near {}, the unstable one. Two circles through the unstable axis, the separatrix, divide the two "
      "kinds of motion; on them the time is infinite. The scene's own L is marked; it flips every {}.",
      timeWords(map.scale().least_s()), axisName(axes.smallest), axisName(axes.largest),
      timeWords(map.scale().most_s()), axisName(axes.middle), timeWords(map.sceneTime_s()));
}

std::string description(const request::SceneRequest& request, const scene::Scene& scene) {
  const LanguageScope language(scene.output.language);
  if (!request.sweep) return altText(scene);
  return request.sweep->map ? mapWords(scene) : gridWords(request, scene);
}

}  // namespace

PictureWords pictureWords(const request::RequestedScene& requested) {
  const scene::Scene& scene = requested.scene;
  const std::string& title = scene.show.title;
  return {title.empty() ? core::printable(scene.name) : text::setTex(title).plainText,
          description(requested.request, requested.cells.empty() ? scene : requested.cells.front())};
}

}  // namespace poinsot::describe
