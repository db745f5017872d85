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

/// How much of each thing is there while the film runs: 0 is not drawn at all, 1 is whole.
class PresencePlan {
 public:
  explicit PresencePlan(const scene::Timeline& timeline);

  /// Of a thing under the name that it has in a scene. What the timeline does not name is always there; what it
  /// shows before it hides it is absent until then.
  double at(std::string_view thing, double filmTime_s) const;

 private:
  std::vector<scene::EasedTrack> tracks_;  // in the order of timelineThings(); empty: all are always there
};

/// Where a draw list and its labels ended before a thing was added.
class DrawMark {
 public:
  DrawMark(const draw::DrawList& list, const std::vector<Label>& labels);

  /// Makes what was added since as if drawn on a board so far: `presence` in (0, 1) of the way. Solids and arrows
  /// grow out of `pivot_V`; lines and tubes are drawn along their length, one after another as they were added;
  /// glass, grids and type grow out of nothing in place.
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
