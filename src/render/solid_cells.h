// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/screen_outline.h"

namespace poinsot::render {

/// Content of a part of the picture as to solids. The values are SOLIDS in composite.frag.
enum class SolidReach : std::uint8_t {
  kNone = 0,
  kInside = 1,   ///< only insides of solids: no edges and no seams
  kOneEdge = 2,  ///< edges, at most one in a pixel
  kTwoEdges = 3
};

struct DepthRange {
  float near = 1e30f, far = -1e30f;

  void include(float t, float margin = 0) {
    near = t - margin < near ? t - margin : near;
    far = t + margin > far ? t + margin : far;
  }
  bool overlaps(const DepthRange& other) const { return near <= other.far && other.near <= far; }
};

/// Cells of the picture in which solids lie, in which their edges lie, and in which two solids may cut each other
/// because they may touch the cell at the same depth.
class SolidCells {
 public:
  using Triangle = std::array<glm::vec2, 3>;

  SolidCells() = default;
  explicit SolidCells(glm::vec2 size_px);

  /// Starts a solid and its first strand of edges. Returns its number, as emit.glsl takes it.
  float nextSolid();
  /// Returns the number of things that cut no solid, such as flat lines.
  static float noSolid() { return shown(kNoSolid); }
  /// Starts a strand. Edges of one strand are never behind one another in a pixel.
  void nextStrand() { ++strand_; }

  /// Marks the pixels that the current solid may touch.
  void markSolid(const PixelBounds& bounds, const DepthRange& depths);
  void markSolid(const Triangle& triangle_px, const DepthRange& depths);
  /// Marks the pixels that an edge of the current strand may touch.
  void markEdge(const PixelBounds& bounds);
  void markEdge(const Triangle& triangle_px);

  bool any() const { return any_; }
  bool anyShared() const { return anyShared_; }
  /// Reports whether two solids may cut each other, or (twoEdges) two edges share a pixel, within the bounds.
  bool shared(const PixelBounds& bounds) const { return !sharedPart(bounds).empty(); }
  bool twoEdges(const PixelBounds& bounds) const { return reach(bounds)[1] == SolidReach::kTwoEdges; }
  /// Returns the bounds of all cells within `bounds` where two solids may cut each other; empty if there are none.
  PixelBounds sharedPart(const PixelBounds& bounds) const;
  /// Returns the least and the greatest reach in any cell of these pixels.
  std::array<SolidReach, 2> reach(const PixelBounds& bounds) const;

  /// Returns the bounds of all cells that hold anything, with their neighbours. They start at a tile's corner, so
  /// that the grouping of pixels that are shaded together does not depend on where the solids are.
  PixelBounds part() const;

 private:
  struct Solid {
    std::uint16_t number = 0;  // 0: unused
    DepthRange depths;
  };
  struct Cell {
    std::array<Solid, 3> solids;
    std::uint32_t strand = 0;  // 0: no edge
    bool shared = false, manyStrands = false;

    SolidReach reach() const;
  };
  static constexpr std::uint16_t kNoSolid = 1;

  static float shown(std::uint16_t number) { return static_cast<float>(number) / 65535.0f; }
  template <typename Use>
  void forEachCell(const PixelBounds& bounds, Use use) const;
  template <typename Use>
  void forEachCell(const Triangle& triangle, Use use) const;
  void addSolid(Cell& cell, const DepthRange& depths);
  void addEdge(Cell& cell);
  std::size_t cellAt(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }

  glm::vec2 size_px_{0};
  int columns_ = 0, rows_ = 0;
  std::uint16_t solid_ = kNoSolid;
  std::uint32_t strand_ = 0;
  bool any_ = false, anyShared_ = false;
  std::vector<Cell> cells_;
};

}  // namespace poinsot::render
