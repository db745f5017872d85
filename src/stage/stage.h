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

/// Composer of a scene's pictures: views and plots side by side at one instant, with titles, notes and read-outs.
/// compose() is a pure function of the moment.
class Stage final : public Composer {
 public:
  /// @throws core::Error(kPhysics) if the scene shows something that its motion does not have (the invariable
  /// plane of a body at rest).
  /// @param steps  ledger for the time spent on the motion, or null; with a ledger, only one thread may use the
  /// stage
  explicit Stage(const scene::Scene& scene, core::StepLedger* steps = nullptr);
  /// Constructs the stage from drawnMotion() of the scene.
  /// @param least  ranges that plots and read-outs hold besides their own; may be empty
  Stage(scene::Scene scene, const std::shared_ptr<const physics::Motion>& motion, const FilmRanges& least = {});

  using Composer::compose;
  draw::Picture compose(const Moment& moment, glm::ivec2 size_px, const Sizing& sizing) const override;
  /// Returns a picture to stand beside pictures of other stages. Other films may be longer, so the moment may lie
  /// beyond the end of this film.
  /// @param mostMetre_px  limits on the pixels per metre of the body, one for each view; empty: no limits
  /// @pre as Composer::compose(); mostMetre_px is empty or has one for each view.
  draw::Picture compose(const Moment& moment, glm::ivec2 size_px, const Sizing& sizing,
                        std::span<const double> mostMetre_px) const;

  /// Returns the largest possible pixels per metre of the body in each view of a picture of this size.
  std::vector<double> metres_px(glm::ivec2 size_px, const Sizing& sizing) const;

  /// Returns how many times larger than the body the path of its flight is drawn; the least of all views.
  double flightScale() const;

  const scene::Scene& scene() const { return scene_; }
  /// Returns seconds of motion per second of film: the scene's speed, or the one from scene::chosenSpeed().
  double speed() const { return chosenSpeed(scene_); }

 private:
  struct Arrangement {
    PictureWriting writing;
    std::vector<Cell> cells;  ///< cells of the views, then of the plots
    std::vector<PanelFrame> frames;
  };

  Arrangement arrange(draw::Picture& picture, double filmTime_s, const Sizing& sizing) const;
  PictureWriting writing(double filmTime_s, glm::ivec2 size_px, const Sizing& sizing) const;
  /// Returns true if type stands over a single view. Otherwise type stands beside the panels.
  bool writesOverView() const { return views_.size() == 1 && plots_.empty(); }
  std::vector<PanelFrame> framesOf(draw::Picture& picture, const std::vector<Cell>& cells, const Sizing& sizing,
                                   const PictureWriting& writing) const;
  void addPlots(draw::Picture& picture, std::span<const Cell> cells, const Sizing& own, double filmTime_s) const;
  void makeRoomFor(const PictureWriting& writing, PanelFrame& frame) const;

  /// Returns the height of the strip for captions under the panels; 0 without captions.
  int strip_px(glm::ivec2 size_px, const Sizing& sizing) const;

  scene::Scene scene_;
  Palette colors_;
  std::vector<ViewStage> views_;
  std::vector<PlotFigure> plots_;
  PictureLayout layout_;
  ReadoutBoard readouts_;
  PresencePlan presence_;
  CaptionStrip captions_;
};

}  // namespace poinsot::stage
