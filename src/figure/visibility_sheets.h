// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "figure/visibility_solids.h"

namespace poinsot::figure {

/// Where a line of sight passes a sheet.
struct SheetHit {
  double t = 0;
  double opacity = 0;
  draw::Color color{0};    ///< linear light
  std::uint64_t mark = 0;  ///< one bit for each side of each sheet (of the first 64)
};

/// Something translucent, as the eye has it.
class Sheet {
 public:
  virtual ~Sheet() = default;
  /// Adds the places nearer than `t` where the line of sight passes it.
  virtual void meet(const SightLine& sight, double t, std::vector<SheetHit>& hits) const = 0;
};

/// Every sheet of a list that is wholly in front of the camera.
std::vector<std::unique_ptr<const Sheet>> sheetsOf(const draw::DrawList& list);

}  // namespace poinsot::figure
