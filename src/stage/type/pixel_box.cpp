// SPDX-License-Identifier: Apache-2.0
#include "stage/type/pixel_box.h"

namespace poinsot::stage {

double PixelBox::x(double share) const { return left + share * width(); }

double PixelBox::y(double share) const { return bottom - share * height(); }

}  // namespace poinsot::stage
