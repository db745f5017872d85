// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "scene/grid_place.h"
#include "scene/keys/findings.h"

namespace poinsot::scene {

/// Grid of the picture. Assigns a position to each panel, which is a view or a plot, in the order of the calls.
class PanelGrid {
 public:
  explicit PanelGrid(Findings& findings) : findings_(findings) {}

  /// Places a panel at cell `at`, or to the right of the previous panel if `at` is empty. Reports a panel that
  /// leaves the grid or covers another panel, as a problem of the key `path`.at.
  /// @param path  table of the panel, such as "plot[1]"; messages also name the panel by this path
  /// @param span  size in columns and rows; one cell if empty
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
