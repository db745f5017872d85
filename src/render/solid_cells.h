// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/screen_outline.h"

namespace poinsot::render {

/// What of solids may be in a part of the picture; the numbers are SOLIDS in composite.frag.
enum class SolidReach : std::uint8_t {
  kNone = 0,
  kInside = 1,   ///< their insides only: no edge, nor where two cut each other
  kOneEdge = 2,  ///< edges, but at most one in a pixel
  kTwoEdges = 3
};

/// From where to where something is, along the view.
struct DepthRange {
  float near = 1e30f, far = -1e30f;

  void include(float t, float margin = 0) {
    near = t - margin < near ? t - margin : near;
    far = t + margin > far ? t + margin : far;
  }
  bool overlaps(const DepthRange& other) const { return near <= other.far && other.near <= far; }
};

/// Where the solids are in the picture, cell by cell, where their edges are, and where they may cut each other:
/// the cells that two of them may touch at one depth.
class SolidCells {
 public:
  using Triangle = std::array<glm::vec2, 3>;

  SolidCells() = default;
  explicit SolidCells(glm::vec2 size_px);

  /// A number for the next solid, as emit.glsl takes it. Begins a strand.
  float nextSolid();
  /// What a thing has that cuts nothing: a flat line.
  static float noSolid() { return shown(kNoSolid); }
  /// Edges of one strand are never behind one another in a pixel.
  void nextStrand() { ++strand_; }

  /// The solid whose number was given last may touch these pixels.
  void markSolid(const PixelBounds& bounds, const DepthRange& depths);
  void markSolid(const Triangle& triangle_px, const DepthRange& depths);
  /// An edge of the strand begun last may.
  void markEdge(const PixelBounds& bounds);
  void markEdge(const Triangle& triangle_px);

  bool any() const { return any_; }
  bool anyShared() const { return anyShared_; }
  /// Whether two solids may cut each other, or two edges be in one pixel, in any of the pixels.
  bool shared(const PixelBounds& bounds) const { return !sharedPart(bounds).empty(); }
  bool twoEdges(const PixelBounds& bounds) const { return reach(bounds)[1] == SolidReach::kTwoEdges; }
  /// What encloses all cells within the bounds where two solids may cut each other; empty where there are none.
  PixelBounds sharedPart(const PixelBounds& bounds) const;
  /// The least and the most that is in any cell of these pixels.
  std::array<SolidReach, 2> reach(const PixelBounds& bounds) const;

  /// What encloses all cells that hold anything, with those next to them. It begins where a tile does: blocks of
  /// pixels that are shaded together are the same wherever the solids are.
  PixelBounds part() const;

 private:
  struct Solid {
    std::uint16_t number = 0;  // 0: none
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
