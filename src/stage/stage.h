// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/step_times.h"
#include "draw/picture.h"
#include "scene/scene.h"
#include "stage/caption_strip.h"
#include "stage/lettering.h"
#include "stage/note_layout.h"
#include "stage/palette.h"
#include "stage/picture_layout.h"
#include "stage/picture_motion.h"
#include "stage/plot_figure.h"
#include "stage/presence.h"
#include "stage/readout_board.h"
#include "stage/view_stage.h"

namespace poinsot::stage {

/// Turns a scene into pictures-as-values: its views and plots side by side, all at the same instant, with what is
/// written into the picture. compose() is a pure function of the film time.
class Stage {
 public:
  /// @throws core::Error(kPhysics) where the scene asks for something its motion does not have
  /// (the invariable plane of a body at rest).
  /// @param steps  where the time of the motion is entered; then it is of one thread.
  explicit Stage(const scene::Scene& scene, core::StepLedger* steps = nullptr);

  /// What the picture shows at film time `filmTime_s`, for a picture of `size_px` (width, height).
  draw::Picture compose(double filmTime_s, glm::ivec2 size_px) const;
  /// With type and lines of a size of their own, such as printSizing().
  draw::Picture compose(double filmTime_s, glm::ivec2 size_px, const Sizing& sizing) const;

  const scene::Scene& scene() const { return scene_; }
  /// Motion seconds per film second: the scene's, or the one chosen from |omega|.
  double speed() const { return chosenSpeed(scene_); }

 private:
  /// The type that stands still, at an instant; its places do not depend on it.
  struct Writing {
    std::vector<NoteBlock> blocks;
    std::vector<PixelBox> boxes;
    NoteReach reach;
  };

  Stage(scene::Scene scene, const std::shared_ptr<const physics::Motion>& motion);

  Writing writing(double filmTime_s, glm::ivec2 size_px, const Sizing& sizing) const;
  /// Type stands over the picture where that is one view, else beside the panels.
  bool writesOverView() const { return views_.size() == 1 && plots_.empty(); }
  /// Adds the panels' headings to the picture.
  std::vector<PanelFrame> framesOf(draw::Picture& picture, const std::vector<Cell>& cells, const Sizing& sizing,
                                   const Writing& writing) const;
  void addPlots(draw::Picture& picture, std::span<const Cell> cells, const Sizing& sizing,
                double filmTime_s) const;
  void makeRoomFor(const Writing& writing, PanelFrame& frame) const;

  /// Under the panels, for captions; 0 without any.
  int strip_px(glm::ivec2 size_px, const Sizing& sizing) const;

  scene::Scene scene_;
  Palette colors_;
  std::vector<ViewStage> views_;
  std::vector<PlotFigure> plots_;
  PictureLayout layout_;  ///< of the views, then the plots
  ReadoutBoard readouts_;
  PresencePlan presence_;
  CaptionStrip captions_;
};

}  // namespace poinsot::stage
