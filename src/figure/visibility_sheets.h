// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "figure/visibility_solids.h"

namespace poinsot::figure {

struct SheetHit {
  double t = 0;
  double opacity = 0;
  draw::Color color{0};    ///< linear light
  std::uint64_t mark = 0;  ///< one bit that identifies the side of the sheet; 0 if there are more than 64 sides
};

class Sheet {
 public:
  virtual ~Sheet() = default;
  /// Adds the points at which the line of sight meets the sheet, if they are nearer than `t`.
  virtual void meet(const SightLine& sight, double t, std::vector<SheetHit>& hits) const = 0;
};

/// Returns the sheets of a list that are completely in front of the camera.
std::vector<std::unique_ptr<const Sheet>> sheetsOf(const draw::DrawList& list);

}  // namespace poinsot::figure
