// SPDX-License-Identifier: Apache-2.0
#include "request/scene_request.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.h"
#include "request/sweep_cells.h"
#include "scene/scene_file.h"
#include "text/math_setter.h"

namespace poinsot::request {
namespace {

std::string texProblem(std::string_view tex) {
  try {
    text::setTex(tex);
    return "";
  } catch (const core::Error& error) {
    return error.message();
  }
}

void showOnly(std::size_t which, scene::Scene& scene) {
  const std::size_t count = scene.views.size();
  if (which >= count)
    throw core::usageError(count == 0 ? "--view: the scene has no view; leave it out"
                                      : fmt::format("--view {}: the scene has {} view{}; give {}", which + 1,
                                                    count, count == 1 ? "" : "s",
                                                    count == 1 ? "1" : fmt::format("1 to {}", count)));
  scene::View view = std::move(scene.views[which]);
  view.place = {};
  scene.views = {std::move(view)};
  scene.plots.clear();
}

/// Returns the request of a sweep's first cell. If no override contains a range, first loads the scene without the
/// sweep. A misspelt key is then reported as an unknown key and not as a missing range.
SceneRequest firstCell(const SceneRequest& request) {
  if (!request.sweep->map && std::ranges::none_of(request.overrides, [](const std::string& word) {
        return scene::sweepAxis(word).has_value();
      })) {
    SceneRequest plain = request;
    plain.sweep.reset();
    loadRequested(plain);
  }
  return cellRequest(request, SweepGrid(request), 0);
}

}  // namespace

SceneRequest readSceneRequest(const std::string& fileName, std::vector<std::string> overrides,
                              const scene::Allowance& allowance) {
  return {fileName, scene::readSceneText(fileName, allowance.limits), std::move(overrides), std::nullopt,
          allowance};
}

scene::Scene loadRequested(const SceneRequest& request) {
  if (request.sweep) return loadRequested(firstCell(request));
  scene::Scene scene =
      scene::parseScene(request.text, request.fileName, request.overrides, texProblem, request.allowance);
  if (request.view) showOnly(*request.view, scene);
  if (request.size) {
    scene.output.width = request.size->width;
    scene.output.height = request.size->height;
  }
  return scene;
}

}  // namespace poinsot::request
