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
  /// @param steps  ledger for the time spent on the motion, or null; with a ledger, only one thread may use the
  /// stage
  /// @throws core::Error(kPhysics) if the scene shows something that its motion does not have, such as the
  /// invariable plane of a body at rest.
  explicit Stage(const scene::Scene& scene, core::StepLedger* steps = nullptr);
  /// Constructs the stage with a motion that the caller has already computed.
  /// @param motion  drawnMotion() of the scene
  /// @param least  ranges that plots and read-outs cover in addition to their own values; may be empty
  Stage(scene::Scene scene, const std::shared_ptr<const physics::Motion>& motion, const FilmRanges& least = {});

  using Composer::compose;
  draw::Picture compose(const Moment& moment, glm::ivec2 size_px, const Sizing& sizing) const override;
  /// Returns a picture that will be placed beside pictures of other stages. Other films may be longer, so the
  /// moment may lie beyond the end of this film.
  /// @param mostMetre_px  largest scale of the body in each view, in pixels per metre; empty: no limits
  /// @pre as Composer::compose(); mostMetre_px is empty or has one for each view.
  draw::Picture compose(const Moment& moment, glm::ivec2 size_px, const Sizing& sizing,
                        std::span<const double> mostMetre_px) const;

  /// Returns the largest possible scale of the body in each view of a picture of this size, in pixels per metre.
  std::vector<double> metres_px(glm::ivec2 size_px, const Sizing& sizing) const;

  /// Returns the scale of the flight's path relative to the scale of the body. With several views, returns the
  /// smallest ratio.
  double flightScale() const;

  const scene::Scene& scene() const { return scene_; }
  /// Returns seconds of motion per second of film, from scene::chosenSpeed().
  double speed() const { return chosenSpeed(scene_); }

 private:
  struct Arrangement {
    PictureWriting writing;
    std::vector<Cell> cells;  ///< grid cells of all views, followed by those of all plots
    std::vector<PanelFrame> frames;
  };

  Arrangement arrange(draw::Picture& picture, double filmTime_s, const Sizing& sizing) const;
  PictureWriting writing(double filmTime_s, glm::ivec2 size_px, const Sizing& sizing) const;
  /// Returns true if titles and notes lie over the only view. Otherwise they are placed outside the panels.
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
