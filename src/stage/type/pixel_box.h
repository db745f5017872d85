// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/abi.h"

namespace poinsot::stage {

/// Rectangle of the picture, px from its top left corner, y down.
struct PixelBox {
  double left = 0, top = 0, right = 0, bottom = 0;

  double width() const { return right - left; }
  double height() const { return bottom - top; }
  /// Return coordinates inside the box, from shares of the width from the left and of the height from the bottom.
  double x(double share) const;
  double y(double share) const;

  bool operator==(const PixelBox&) const = default;
};

/// Returns true if two boxes are nearer to one another than `apart`.
inline bool near(const PixelBox& a, const PixelBox& b, double apart = 0) {
  return a.left < b.right + apart && b.left < a.right + apart && a.top < b.bottom + apart &&
         b.top < a.bottom + apart;
}

}  // namespace poinsot::stage
