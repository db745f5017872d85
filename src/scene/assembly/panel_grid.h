// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "scene/grid_place.h"
#include "scene/keys/findings.h"

namespace poinsot::scene {

/// Grid of the picture that assigns places to panels, views and plots alike, one after another.
class PanelGrid {
 public:
  explicit PanelGrid(Findings& findings) : findings_(findings) {}

  /// Places a panel at `at` or, without `at`, to the right of the previous panel. Rejects at `path`.at a panel
  /// that leaves the grid or covers another.
  /// @param path  such as "plot[1]"; also names the panel in messages
  /// @param span  columns and rows; one cell if empty
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
