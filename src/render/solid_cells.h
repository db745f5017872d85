// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/screen_outline.h"

namespace poinsot::render {

/// Kind of content that solids have in a part of the picture. The values are those of SOLIDS in composite.frag.
enum class SolidReach : std::uint8_t {
  kNone = 0,
  kInside = 1,   ///< only interiors of solids, no edges and no seams
  kOneEdge = 2,  ///< edges, but at most one per pixel
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

/// Map of the cells of a picture: which cells contain solids, which contain edges of solids, and which contain a
/// possible seam. A seam is a line along which two solids intersect. A cell may contain one if two solids have
/// overlapping ranges of depth in the cell.
class SolidCells {
 public:
  using Triangle = std::array<glm::vec2, 3>;

  SolidCells() = default;
  explicit SolidCells(glm::vec2 size_px);

  /// Starts a solid and its first strand of edges. Returns the solid's number / 65535, for emit.glsl.
  float nextSolid();
  /// Returns the solid number for things that form no seam with a solid, such as flat lines.
  static float noSolid() { return shown(kNoSolid); }
  /// Starts a strand: a set of edges of which no two lie behind one another in any pixel.
  void nextStrand() { ++strand_; }

  /// Marks the pixels that the current solid may touch. The current solid is the one of the last nextSolid().
  void markSolid(const PixelBounds& bounds, const DepthRange& depths);
  void markSolid(const Triangle& triangle_px, const DepthRange& depths);
  /// Marks the pixels that an edge of the current strand may touch.
  void markEdge(const PixelBounds& bounds);
  void markEdge(const Triangle& triangle_px);

  bool any() const { return any_; }
  bool anyShared() const { return anyShared_; }
  /// Whether two solids may intersect (shared) or two edges may share a pixel (twoEdges) within the bounds.
  bool shared(const PixelBounds& bounds) const { return !sharedPart(bounds).empty(); }
  bool twoEdges(const PixelBounds& bounds) const { return reach(bounds)[1] == SolidReach::kTwoEdges; }
  /// Returns the bounds of the cells within `bounds` in which two solids may intersect. Empty if there are none.
  PixelBounds sharedPart(const PixelBounds& bounds) const;
  /// Returns the smallest and the largest SolidReach of the cells within the bounds.
  std::array<SolidReach, 2> reach(const PixelBounds& bounds) const;

  /// Returns the bounds of all cells that contain solids or edges, and of their neighbours. The bounds start at
  /// the corner of a tile. The grouping of pixels in shading then does not depend on the solids' position.
  PixelBounds part() const;

 private:
  struct Solid {
    std::uint16_t number = 0;  // 0: unused
    DepthRange depths;
  };
  struct Cell {
    std::array<Solid, 3> solids;
    std::uint32_t strand = 0;  // last strand with an edge in this cell; 0 if there is none
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
