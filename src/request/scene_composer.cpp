// SPDX-License-Identifier: Apache-2.0
#include "request/scene_composer.h"

#include "request/sweep_cells.h"
#include "stage/stability_map.h"
#include "stage/stage.h"
#include "stage/sweep_stage.h"

namespace poinsot::request {

std::unique_ptr<const stage::Composer> composerOf(const RequestedScene& requested, core::StepLedger* steps) {
  const auto& [request, scene, cells] = requested;
  if (!request.sweep) return std::make_unique<stage::Stage>(scene, steps);
  if (request.sweep->map) return std::make_unique<stage::StabilityMap>(scene);
  const SweepGrid grid(request);
  return std::make_unique<stage::SweepStage>(cells, stage::sweepLabels(grid.axes, request.sweep->labels, scene),
                                             request.sweep->columns, steps);
}

stage::Sizing sizingOf(const PictureForm& form, glm::ivec2 size_px) {
  return form.print ? stage::printSizing(form.print->dpi) : stage::screenSizing(size_px);
}

}  // namespace poinsot::request
