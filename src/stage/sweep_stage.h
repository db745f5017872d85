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

/// Film time that the cells of a sweep show.
enum class CellTime {
  kOfPicture,  ///< all cells show the moment of the picture
  kOfScene,    ///< each cell shows time.still of its scene, so that the cells are instants of one film
};

/// Composer of small multiples: scenes that differ in one or two values, side by side. Title, notes and captions
/// come from the first scene and appear once. If one value differs, each cell is labelled with its
/// value. If two values differ, the columns and rows are labelled. Bodies have one scale if possible, and plots
/// have the same axes.
class SweepStage final : public Composer {
 public:
  /// @param cells  scenes of the cells, row by row; all have the same duration, size and paper
  /// @param labels  labels of one range, or of two ranges with the columns' range first
  /// @param columns  number of columns for one range; 0: the number that makes the cells largest
  /// @param time  film time of the cells
  /// @param steps  ledger for the time spent on the motions, or null; with a ledger, only one thread may use the
  /// stage
  /// @throws core::Error(kPhysics) if a cell shows something that its motion does not have.
  SweepStage(std::vector<scene::Scene> cells, std::vector<SweepLabels> labels, int columns,
             CellTime time = CellTime::kOfPicture, core::StepLedger* steps = nullptr);

  using Composer::compose;
  draw::Picture compose(const Moment& moment, glm::ivec2 size_px, const Sizing& sizing) const override;

 private:
  struct Grid {
    int columns = 1, rows = 1;
    glm::ivec2 origin_px{0}, cell_px{1}, pitch_px{1};
    Sizing sizing;  ///< sizes of text and lines in a cell
    double label_px = 1;

    glm::ivec2 originOf(int cell) const {
      return origin_px + pitch_px * glm::ivec2(cell % columns, cell / columns);
    }
  };

  /// Returns true if a second range varies from row to row. Labels are then at the columns and rows, not at each
  /// cell.
  bool hasRows() const { return labels_.size() == 2; }
  /// Returns the moment that a cell shows in a picture of the given moment.
  Moment momentOf(const Stage& cell, const Moment& picture) const;
  double margin_em() const;
  double labelSize_px(const Sizing& type, glm::dvec2 cell_px, glm::dvec2 room_px) const;
  int columnsFor(glm::ivec2 size_px) const;
  Grid gridIn(const Cell& room, glm::ivec2 picture_px, const Sizing& sizing) const;
  void addLabels(draw::Picture& picture, const Grid& grid) const;
  std::vector<double> mostMetre_px(const Grid& grid) const;

  scene::Scene written_;
  std::vector<SweepLabels> labels_;
  int columns_;
  CellTime time_;
  Palette colors_;
  PresencePlan presence_;
  CaptionStrip captions_;
  std::vector<Stage> cells_;
};

}  // namespace poinsot::stage
