// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "draw/picture.h"
#include "physics/motion.h"
#include "scene/scene.h"
#include "stage/picture_layout.h"
#include "stage/quantity_track.h"
#include "stage/type/lettering.h"

namespace poinsot::stage {

/// Room between a panel's sides and the ends of its horizontal axis, px.
struct PlotSides {
  double left = 0, right = 0;
};

/// Ranges of values that the axes of a plot must hold.
struct PlotRanges {
  QuantityRange y;
  std::optional<QuantityRange> x;
};

/// Returns ranges that hold both, for plots that are to be compared. @pre both are of one kind.
PlotRanges joined(const PlotRanges& a, const PlotRanges& b);

/// Panel with curves of a scene's quantities over its film, a cursor at the film time, and the values there. The
/// constructor computes everything that does not depend on time or size.
class PlotFigure {
 public:
  /// @param motion  drawnMotion() of the scene
  /// @param least  ranges that the axes hold besides the plot's own curves
  /// @pre the plot's quantities are of one unit; a phase portrait has one quantity.
  PlotFigure(const scene::Scene& scene, const scene::Plot& plot, std::shared_ptr<const physics::Motion> motion,
             const std::optional<PlotRanges>& least = {});
  ~PlotFigure();
  PlotFigure(PlotFigure&&) noexcept;

  /// Returns the ranges of the plot's curves, joined with those passed to the constructor.
  const PlotRanges& ranges() const;

  /// Returns the factor by which type shrinks to fit into a cell: 1, or less in a small cell.
  double typeShare(const Cell& cell, const Sizing& sizing) const;

  /// Returns the room that the plot needs beside its axis of time; nothing for a phase portrait.
  PlotSides sides(const Cell& cell, const Sizing& sizing) const;

  /// Adds the panel at a film time to a picture. Nothing reaches beyond the panel. A pure function.
  /// @param least  room to leave beside an axis of time, so that axes of plots under one another are in line
  void add(draw::Picture& picture, const Cell& cell, const Sizing& sizing, double filmTime_s,
           const PlotSides& least = {}) const;

 private:
  struct Plan;
  std::unique_ptr<const Plan> plan_;
};

}  // namespace poinsot::stage
