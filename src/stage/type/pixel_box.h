// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/abi.h"

namespace poinsot::stage {

/// Rectangle in the picture, px from the picture's top left corner, y down.
struct PixelBox {
  double left = 0, top = 0, right = 0, bottom = 0;

  double width() const { return right - left; }
  double height() const { return bottom - top; }
  /// Return the coordinate at a fraction of the width from the left, or at a fraction of the height from the
  /// bottom.
  double x(double share) const;
  double y(double share) const;

  bool operator==(const PixelBox&) const = default;
};

/// Returns true if the gap between two boxes is smaller than `apart`, both across and down.
inline bool near(const PixelBox& a, const PixelBox& b, double apart = 0) {
  return a.left < b.right + apart && b.left < a.right + apart && a.top < b.bottom + apart &&
         b.top < a.bottom + apart;
}

}  // namespace poinsot::stage
