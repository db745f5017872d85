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

/// Presence of each object or text over the film, from 0 (not drawn) to 1 (drawn completely).
class PresencePlan {
 public:
  explicit PresencePlan(const scene::Timeline& timeline);

  /// Returns the presence of an object or text. An object that the timeline does not name always has presence 1.
  /// An object that the timeline shows before hiding it is absent until then.
  /// @param thing  name in a scene, such as "plane"
  double at(std::string_view thing, double filmTime_s) const;

 private:
  std::vector<scene::EasedTrack> tracks_;  // in the order of timelineThings(); empty: everything is always shown
};

/// Sizes of a draw list and of its labels at one moment. Objects that are added later can then be drawn partly.
class DrawMark {
 public:
  DrawMark(const draw::DrawList& list, const std::vector<Label>& labels);

  /// Makes everything that was added since the mark look partly drawn. Solids and arrows grow out of `pivot_V`.
  /// Lines and tubes are drawn along their length, one after another in the order of adding. Glass, grids and text
  /// fade in.
  /// @param presence  progress of the drawing, in (0, 1)
  void fade(draw::DrawList& list, std::vector<Label>& labels, const Eigen::Vector3d& pivot_V,
            double presence) const;

 private:
  void growSolids(draw::DrawList& list, const glm::vec3& pivot_V, float presence) const;
  void drawLines(draw::DrawList& list, float presence) const;
  void thinGlass(draw::DrawList& list, float presence) const;

  std::size_t ellipsoids_, frustums_, boxes_, meshes_, curves_, glassEllipsoids_, glassCones_, glassPolygons_,
      planes_, texts_, points_, labels_;
};

}  // namespace poinsot::stage
