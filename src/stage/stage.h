// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/step_times.h"
#include "draw/picture.h"
#include "scene/scene.h"
#include "stage/composer.h"
#include "stage/figures/presence.h"
#include "stage/film_ranges.h"
#include "stage/palette.h"
#include "stage/picture_layout.h"
#include "stage/picture_motion.h"
#include "stage/type/caption_strip.h"
#include "stage/type/picture_writing.h"
#include "stage/type/readout_board.h"
#include "stage/view_stage.h"

namespace poinsot::stage {

/// Turns a scene into pictures-as-values: its views and plots side by side, all at the same instant, with what is
/// written into the picture. compose() is a pure function of the moment.
class Stage final : public Composer {
 public:
  /// @throws core::Error(kPhysics) where the scene asks for something its motion does not have
  /// (the invariable plane of a body at rest).
  /// @param steps  where the time of the motion is entered; then it is of one thread.
  explicit Stage(const scene::Scene& scene, core::StepLedger* steps = nullptr);
  /// With drawnMotion() of the scene. @param least  what its plots and read-outs hold besides their own; or
  /// nothing
  Stage(scene::Scene scene, const std::shared_ptr<const physics::Motion>& motion, const FilmRanges& least = {});

  using Composer::compose;
  draw::Picture compose(const Moment& moment, glm::ivec2 size_px, const Sizing& sizing) const override;
  /// Beside pictures of other stages, whose film may be longer: a metre of the body has no more pixels than these
  /// say, one for each view; without any, as many as it can have.
  /// @pre as Composer::compose(); mostMetre_px is empty or has one for each view.
  draw::Picture compose(const Moment& moment, glm::ivec2 size_px, const Sizing& sizing,
                        std::span<const double> mostMetre_px) const;

  /// The pixels that a metre of the body can have in each view of such a picture.
  std::vector<double> metres_px(glm::ivec2 size_px, const Sizing& sizing) const;

  /// How many times as large as the body the path of its flight is drawn, in the view where that is least.
  double flightScale() const;

  const scene::Scene& scene() const { return scene_; }
  /// Motion seconds per film second: the scene's, or the one that scene::chosenSpeed() chooses.
  double speed() const { return chosenSpeed(scene_); }

 private:
  /// What is where in a picture.
  struct Arrangement {
    PictureWriting writing;
    std::vector<Cell> cells;  ///< of the views, then the plots
    std::vector<PanelFrame> frames;
  };

  /// Adds the panels' headings to the picture.
  Arrangement arrange(draw::Picture& picture, double filmTime_s, const Sizing& sizing) const;
  PictureWriting writing(double filmTime_s, glm::ivec2 size_px, const Sizing& sizing) const;
  /// Type stands over the picture where that is one view, else beside the panels.
  bool writesOverView() const { return views_.size() == 1 && plots_.empty(); }
  std::vector<PanelFrame> framesOf(draw::Picture& picture, const std::vector<Cell>& cells, const Sizing& sizing,
                                   const PictureWriting& writing) const;
  void addPlots(draw::Picture& picture, std::span<const Cell> cells, const Sizing& own, double filmTime_s) const;
  void makeRoomFor(const PictureWriting& writing, PanelFrame& frame) const;

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
