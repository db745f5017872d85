// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/step_times.h"
#include "scene/scene.h"
#include "stage/composer.h"
#include "stage/figures/presence.h"
#include "stage/palette.h"
#include "stage/picture_layout.h"
#include "stage/stage.h"
#include "stage/type/caption_strip.h"
#include "stage/type/sweep_label.h"

namespace poinsot::stage {

/// Small multiples: scenes that differ in a value or two, side by side, at one instant. Title, notes and captions
/// are the first scene's and stand once; at each cell its value is written, of two ranges at the columns and at
/// the rows. Bodies have one scale where they can, plots have the same axes.
class SweepStage final : public Composer {
 public:
  /// @param cells  row by row, all of one length, size and paper
  /// @param labels  of one range or of two, that of the columns first
  /// @param columns  of the grid of one range; 0: as many as make the cells largest
  /// @param steps  where the time of the motions is entered; then it is of one thread.
  /// @throws core::Error(kPhysics) where a cell asks for something its motion does not have.
  SweepStage(std::vector<scene::Scene> cells, std::vector<SweepLabels> labels, int columns,
             core::StepLedger* steps = nullptr);

  using Composer::compose;
  draw::Picture compose(const Moment& moment, glm::ivec2 size_px, const Sizing& sizing) const override;

 private:
  /// Of a picture of some size: cells of one size, and the type of what is in them.
  struct Grid {
    int columns = 1, rows = 1;
    glm::ivec2 origin_px{0}, cell_px{1}, pitch_px{1};  ///< of the first cell, under its label; from cell to cell
    Sizing sizing;                                     ///< of what is in the cells
    double label_px = 1;                               ///< size of the type of the labels

    glm::ivec2 originOf(int cell) const {
      return origin_px + pitch_px * glm::ivec2(cell % columns, cell / columns);
    }
  };

  /// A second range, from top to bottom: then labels stand at the columns and at the rows.
  bool hasRows() const { return labels_.size() == 2; }
  double margin_em() const;
  double labelSize_px(const Sizing& type, glm::dvec2 cell_px, glm::dvec2 room_px) const;
  int columnsFor(glm::ivec2 size_px, glm::ivec2 picture_px) const;
  Grid gridIn(const Cell& room, glm::ivec2 picture_px, const Sizing& sizing) const;
  void addLabels(draw::Picture& picture, const Grid& grid) const;
  /// For each view, as Stage::compose() takes it.
  std::vector<double> mostMetre_px(const Grid& grid) const;

  scene::Scene written_;  // whose title and notes stand over all
  std::vector<SweepLabels> labels_;
  int columns_;
  Palette colors_;
  PresencePlan presence_;
  CaptionStrip captions_;
  std::vector<Stage> cells_;
};

}  // namespace poinsot::stage
