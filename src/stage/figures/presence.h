// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "draw/draw_list.h"
#include "scene/motion/eased_track.h"
#include "scene/timeline.h"
#include "stage/type/label_layout.h"

namespace poinsot::stage {

/// Presence of each drawn object or text over the film: 0 is not drawn at all, 1 is whole.
class PresencePlan {
 public:
  explicit PresencePlan(const scene::Timeline& timeline);

  /// Returns the presence of a thing, by its name in a scene. A thing that the timeline does not name is always
  /// there. A thing that the timeline shows before hiding it is absent until then.
  double at(std::string_view thing, double filmTime_s) const;

 private:
  std::vector<scene::EasedTrack> tracks_;  // in the order of timelineThings(); empty: everything is always there
};

/// Ends of a draw list and of its labels before a thing is added.
class DrawMark {
 public:
  DrawMark(const draw::DrawList& list, const std::vector<Label>& labels);

  /// Makes everything added since the mark look partly drawn. Solids and arrows grow out of `pivot_V`. Lines and
  /// tubes are drawn along their length, one after another in the order of adding. Glass, grids and type fade in.
  /// @param presence  progress of the drawing, in (0, 1)
  void fade(draw::DrawList& list, std::vector<Label>& labels, const Eigen::Vector3d& pivot_V,
            double presence) const;

 private:
  void growSolids(draw::DrawList& list, const glm::vec3& pivot_V, float presence) const;
  void drawLines(draw::DrawList& list, float presence) const;
  void thinGlass(draw::DrawList& list, float presence) const;

  std::size_t ellipsoids_, frustums_, boxes_, meshes_, curves_, glassEllipsoids_, glassCones_, glassPolygons_,
      planes_, texts_, labels_;
};

}  // namespace poinsot::stage
