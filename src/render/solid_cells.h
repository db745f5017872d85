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
  kInside = 1,  ///< their insides only: no edge, nor where two cut each other
  kEdges = 2
};

/// Where the solids are in the picture, cell by cell, and where they may cut each other: the cells that more than
/// one of them may touch.
class SolidCells {
 public:
  SolidCells() = default;
  explicit SolidCells(glm::vec2 size_px);

  /// A number for the next solid, as emit.glsl takes it.
  float nextSolid();
  /// What a thing has that cuts nothing: a flat line.
  static float noSolid() { return shown(kNone); }

  /// The solid whose number was given last may touch these pixels.
  void mark(const PixelBounds& bounds, SolidReach reach);
  /// And those of a triangle.
  void mark(const std::array<glm::vec2, 3>& triangle_px, SolidReach reach);
  /// A flat line may.
  void markFlat(const std::array<glm::vec2, 3>& triangle_px);
  /// An edge may run through a pixel of what was marked.
  void markEdge(glm::vec2 pixel_px);

  bool any() const { return any_; }
  bool anyShared() const { return anyShared_; }
  /// Whether any of the pixels may be touched by two solids.
  bool shared(const PixelBounds& bounds) const;
  /// What encloses all such cells within the bounds; empty where there are none.
  PixelBounds sharedPart(const PixelBounds& bounds) const;
  /// The least and the most that is in any cell of these pixels.
  std::array<SolidReach, 2> reach(const PixelBounds& bounds) const;
  /// All cells that are marked and those next to them, as rectangles that do not overlap.
  std::vector<PixelBounds> markedAndBeside() const;

 private:
  static constexpr std::uint16_t kNone = 1, kShared = 0xFFFF;

  static float shown(std::uint16_t number) { return static_cast<float>(number) / 65535.0f; }
  template <typename Use>
  void forEachCell(const PixelBounds& bounds, Use use) const;
  template <typename Use>
  void forEachCell(const std::array<glm::vec2, 3>& triangle, Use use) const;
  void markCell(std::size_t cell, SolidReach reach);
  void reachCell(std::size_t cell, SolidReach reach);
  bool anyAround(int column, int row) const;

  glm::vec2 size_px_{0};
  int columns_ = 0, rows_ = 0;
  std::uint16_t last_ = kNone;
  bool any_ = false, anyShared_ = false;
  std::vector<std::uint16_t> solids_;  // the one that touches it, or kShared
  std::vector<SolidReach> reaches_;
};

}  // namespace poinsot::render
