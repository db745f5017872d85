// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/screen_outline.h"

namespace poinsot::render {

/// Where in the picture solids may cut each other: the cells that more than one of them may touch.
class SeamMask {
 public:
  SeamMask() = default;
  explicit SeamMask(glm::vec2 size_px);

  /// A number for the next solid, as emit.glsl takes it.
  float nextSolid();
  /// What a thing has that cuts nothing: a flat line.
  static float noSolid() { return shown(kNone); }

  /// The solid whose number was given last may touch these pixels.
  void mark(const PixelBounds& bounds);
  /// And those of a triangle.
  void mark(const std::array<glm::vec2, 3>& triangle_px);

  bool any() const { return any_; }
  /// Whether any of the pixels may be touched by two solids.
  bool shared(const PixelBounds& bounds) const;
  /// What encloses all such cells within the bounds; empty where there are none.
  PixelBounds sharedPart(const PixelBounds& bounds) const;

 private:
  static constexpr std::uint16_t kNone = 1, kShared = 0xFFFF;

  void markCell(std::size_t cell);
  static float shown(std::uint16_t number) { return static_cast<float>(number) / 65535.0f; }
  template <typename Use>
  void forEachCell(const PixelBounds& bounds, Use use) const;

  glm::vec2 size_px_{0};
  int columns_ = 0;
  std::uint16_t last_ = kNone;
  bool any_ = false;
  std::vector<std::uint16_t> cells_;  // the solid that touches it, or kShared
};

}  // namespace poinsot::render
