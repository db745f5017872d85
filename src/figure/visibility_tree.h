// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

namespace poinsot::figure {

/// Axis-aligned box. It is empty until include() is called.
struct Bounds {
  glm::dvec3 low{1e300};
  glm::dvec3 high{-1e300};

  void include(glm::dvec3 p);
  void include(const Bounds& other);
};

struct Line {
  glm::dvec3 origin{0};
  glm::dvec3 direction{0};
};

/// Tree of bounding boxes. With it, a line is tested only against the objects near the line.
class BoundsTree {
 public:
  explicit BoundsTree(const std::vector<Bounds>& things);

  /// Calls meets(i) for each object i whose box the line enters before `t`. Stops when a call returns true.
  template <typename Meets>
  bool any(const Line& line, double t, const Meets& meets) const {
    std::vector<std::size_t> open;
    if (!nodes_.empty()) open.push_back(0);
    while (!open.empty()) {
      const Node& node = nodes_[open.back()];
      open.pop_back();
      if (!enters(node.bounds, line, t)) continue;
      for (std::size_t i = node.first; i < node.first + node.count; ++i)
        if (meets(order_[i])) return true;
      if (node.count == 0) open.insert(open.end(), {node.left, node.right});
    }
    return false;
  }

 private:
  /// Node of the tree. A leaf has `count` objects from order_[first] on. An inner node has `count` 0.
  struct Node {
    Bounds bounds;
    std::size_t first = 0, count = 0;
    std::size_t left = 0, right = 0;
  };

  static bool enters(const Bounds& bounds, const Line& line, double t);
  std::size_t build(const std::vector<Bounds>& things, std::size_t first, std::size_t count);

  std::vector<Node> nodes_;
  std::vector<std::size_t> order_;
};

}  // namespace poinsot::figure
