// SPDX-License-Identifier: Apache-2.0
// Tiles of the picture, two triangles each.
#include "constants.glsl"

layout(location = 0) in vec2 position_px;

void main() {
  handOn();
  gl_Position = vec4(2.0 * position_px / pictureSize_px - 1.0, 0.0, 1.0);
}
