// SPDX-License-Identifier: Apache-2.0
// Squares of the picture (render/cells.h), one point each.
#include "constants.glsl"

layout(location = 0) in vec3 square_px;  // centre, side

void main() {
  handOn();
  gl_PointSize = square_px.z;
  gl_Position = vec4(2.0 * square_px.xy / pictureSize_px - 1.0, 0.0, 1.0);
}
