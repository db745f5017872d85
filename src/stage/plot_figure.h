// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "draw/picture.h"
#include "physics/motion.h"
#include "scene/scene.h"

namespace poinsot::stage {

/// A panel with curves of a scene's quantities over its film, a cursor at the film's time and the values there.
/// All that does not depend on time or size is worked out once, here.
class PlotFigure {
 public:
  /// `motion`: drawnMotion() of the scene. @pre the plot's quantities are of one unit; one for a phase portrait.
  PlotFigure(const scene::Scene& scene, const scene::Plot& plot, std::shared_ptr<const physics::Motion> motion);
  ~PlotFigure();
  PlotFigure(PlotFigure&&) noexcept;

  /// Adds the panel at film time `filmTime_s` to a picture whose size is set; its type is sized by the picture.
  /// All of it lies inside the panel. A pure function.
  void add(draw::Picture& picture, glm::ivec2 origin_px, glm::ivec2 size_px, double filmTime_s) const;

 private:
  struct Plan;
  std::unique_ptr<const Plan> plan_;
};

}  // namespace poinsot::stage
