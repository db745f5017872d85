// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "scene/grid_place.h"
#include "scene/keys/findings.h"

namespace poinsot::scene {

/// Gives the panels of a picture, views and plots alike, their places, one after another.
class PanelGrid {
 public:
  explicit PanelGrid(Findings& findings) : findings_(findings) {}

  /// Where it says, else to the right of the panel before; `span`: columns and rows, else one cell. What leaves
  /// the grid or covers another is refused at `path`.at. `path` ("plot[1]") is also the panel's name in messages.
  GridPlace take(const std::string& path, const std::optional<Eigen::Vector2i>& at,
                 const std::optional<Eigen::Vector2i>& span);

  bool empty() const { return taken_.empty(); }

 private:
  struct Taken {
    std::string name;
    GridPlace place;
  };

  GridPlace nextTo(const std::optional<Eigen::Vector2i>& at) const;
  void check(const std::string& path, const GridPlace& place);

  Findings& findings_;
  std::vector<Taken> taken_;
};

}  // namespace poinsot::scene
