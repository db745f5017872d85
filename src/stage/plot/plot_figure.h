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

/// Between a panel's sides and the ends of its horizontal axis, px.
struct PlotSides {
  double left = 0, right = 0;
};

/// What the axes of a plot have to hold.
struct PlotRanges {
  QuantityRange y;
  std::optional<QuantityRange> x;  ///< of a phase portrait
};

/// Both, for plots that are to be compared. @pre of one kind.
PlotRanges joined(const PlotRanges& a, const PlotRanges& b);

/// A panel with curves of a scene's quantities over its film, a cursor at the film's time and the values there.
/// All that does not depend on time or size is worked out once, here.
class PlotFigure {
 public:
  /// `motion`: drawnMotion() of the scene. @pre the plot's quantities are of one unit; one for a phase portrait.
  /// @param least  what its axes hold besides its own curves
  PlotFigure(const scene::Scene& scene, const scene::Plot& plot, std::shared_ptr<const physics::Motion> motion,
             const std::optional<PlotRanges>& least = {});
  ~PlotFigure();
  PlotFigure(PlotFigure&&) noexcept;

  /// Of its curves, with those that it was made for.
  const PlotRanges& ranges() const;

  /// What of its type's size fits into a cell: 1, or less in a small one.
  double typeShare(const Cell& cell, const Sizing& sizing) const;

  /// What it needs beside its axis of time; of a phase portrait nothing, which has no such axis.
  PlotSides sides(const Cell& cell, const Sizing& sizing) const;

  /// Adds the panel at film time `filmTime_s` to a picture. All of it lies inside the panel. A pure function.
  /// `least` stays free beside an axis of time, so that those of plots under one another are in line.
  void add(draw::Picture& picture, const Cell& cell, const Sizing& sizing, double filmTime_s,
           const PlotSides& least = {}) const;

 private:
  struct Plan;
  std::unique_ptr<const Plan> plan_;
};

}  // namespace poinsot::stage
