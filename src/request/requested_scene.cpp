// SPDX-License-Identifier: Apache-2.0
#include "request/requested_scene.h"

#include <utility>

#include "request/sweep_cells.h"
#include "stage/stability_map.h"
#include "stage/stage.h"
#include "stage/sweep_stage.h"
#include "stage/type/sweep_label.h"

namespace poinsot::request {

void RequestedScene::resize(image::PixelSize size) {
  request.size = size;
  const auto set = [&](scene::Scene& one) {
    one.output.width = size.width;
    one.output.height = size.height;
  };
  set(scene);
  for (scene::Scene& cell : cells) set(cell);
}

void RequestedScene::setTextSize(double factor) {
  scene.style.textSize = factor;
  for (scene::Scene& cell : cells) cell.style.textSize = factor;
}

RequestedScene requestedScene(SceneRequest request) {
  RequestedScene requested{std::move(request)};
  const auto& sweep = requested.request.sweep;
  requested.scene = loadRequested(requested.request);
  if (sweep && sweep->map) stage::StabilityMap checked(requested.scene);
  if (!sweep || sweep->map) return requested;
  const SweepGrid grid(requested.request);
  stage::sweepLabels(grid.axes, sweep->labels, requested.scene);
  requested.cells = loadCells(requested.request, grid, requested.scene);
  return requested;
}

std::unique_ptr<const stage::Composer> composerOf(const RequestedScene& requested, core::StepLedger* steps) {
  const auto& [request, scene, cells] = requested;
  if (!request.sweep) return std::make_unique<stage::Stage>(scene, steps);
  if (request.sweep->map) return std::make_unique<stage::StabilityMap>(scene);
  const SweepGrid grid(request);
  return std::make_unique<stage::SweepStage>(
      cells, stage::sweepLabels(grid.axes, request.sweep->labels, cells.at(0)), request.sweep->columns,
      grid.variesInstant() ? stage::CellTime::kOfScene : stage::CellTime::kOfPicture, steps);
}

stage::Sizing sizingOf(const PictureOptions& form, const scene::Style& style, glm::ivec2 size_px) {
  const auto& print = form.print;
  if (print && print->type_pt) {
    const double dpi = 25.4 * size_px.x / print->width_mm;  // pixels are whole, so this is not exactly print->dpi
    return stage::fixedSizing(dpi, *print->type_pt * dpi / 72);
  }
  return stage::styled(print ? stage::printSizing(print->dpi) : stage::screenSizing(size_px), style, size_px);
}

}  // namespace poinsot::request
