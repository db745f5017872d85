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

/// Ranges of values that the axes of a plot must cover.
struct PlotRanges {
  QuantityRange y;
  std::optional<QuantityRange> x;
};

/// Returns ranges that cover the values of two plots, so that the plots can have the same axes.
/// @pre both plots have a range of x, or neither plot has one.
PlotRanges joined(const PlotRanges& a, const PlotRanges& b);

/// Panel with curves of a scene's quantities over its film. A cursor marks the current film time, and the values
/// at this time are written beside the curves. The constructor computes everything that does not depend on time or
/// size.
class PlotFigure {
 public:
  /// @param motion  drawnMotion() of the scene
  /// @param least  ranges that the axes cover in addition to the plot's own curves
  /// @pre the plot's quantities are of one unit; a phase portrait has one quantity.
  PlotFigure(const scene::Scene& scene, const scene::Plot& plot, std::shared_ptr<const physics::Motion> motion,
             const std::optional<PlotRanges>& least = {});
  ~PlotFigure();
  PlotFigure(PlotFigure&&) noexcept;

  /// Returns the ranges of the plot's curves, joined with the ranges passed to the constructor.
  const PlotRanges& ranges() const;

  /// Returns the factor by which text shrinks to fit into a cell: 1, or less in a small cell.
  double typeShare(const Cell& cell, const Sizing& sizing) const;

  /// Returns the room that the plot needs beside its time axis; zero for a phase portrait.
  PlotSides sides(const Cell& cell, const Sizing& sizing) const;

  /// Adds the panel at a film time to a picture. Everything stays inside the panel. The result depends only on the
  /// arguments.
  /// @param least  smallest room beside the time axis, used to align the axes of plots in one column
  void add(draw::Picture& picture, const Cell& cell, const Sizing& sizing, double filmTime_s,
           const PlotSides& least = {}) const;

 private:
  struct Plan;
  std::unique_ptr<const Plan> plan_;
};

}  // namespace poinsot::stage
