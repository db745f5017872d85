// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "draw/picture.h"
#include "scene/scene.h"
#include "stage/lettering.h"
#include "stage/palette.h"
#include "stage/picture_layout.h"
#include "stage/view_stage.h"

namespace poinsot::stage {

/// Turns a scene into pictures-as-values: its views side by side, all at the same instant, with what stands still
/// over them. compose() is a pure function of the film time.
class Stage {
 public:
  /// @throws core::Error(kPhysics) where the scene asks for something its motion does not have
  /// (the invariable plane of a body at rest).
  explicit Stage(scene::Scene scene);

  /// What the picture shows at film time `filmTime_s`, for a picture of `size_px` (width, height).
  draw::Picture compose(double filmTime_s, glm::ivec2 size_px) const;
  /// With type and lines of a size of their own, such as printSizing().
  draw::Picture compose(double filmTime_s, glm::ivec2 size_px, const Sizing& sizing) const;

  const scene::Scene& scene() const { return scene_; }
  /// Motion seconds per film second: the scene's, or the one chosen from |omega|.
  double speed() const { return views_.front().speed(); }

 private:
  /// Adds the panels' headings to the picture.
  std::vector<PanelFrame> framesOf(draw::Picture& picture, const std::vector<Cell>& cells, const Sizing& sizing,
                                   double title_px) const;

  scene::Scene scene_;
  Palette colors_;
  std::vector<ViewStage> views_;
  PictureLayout layout_;
};

}  // namespace poinsot::stage
