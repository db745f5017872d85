// SPDX-License-Identifier: Apache-2.0
// Vertex of a curve's strip. The CPU places it, and pieces are straight in pixels, so that widths are exact.
#include "constants.glsl"

layout(location = 0) in vec2 position_px;
layout(location = 1) in vec4 across;     // offset from the line, half width, distance to the end, distance along the view
layout(location = 2) in vec4 tangent_C;  // unit; w: radius of the tube, 0 for a flat line

noperspective out vec4 acrossOut;
noperspective out vec4 tangentOut_C;

void main() {
  handOn();
  acrossOut = across;
  tangentOut_C = tangent_C;
  gl_Position = vec4(2.0 * position_px / pictureSize_px - 1.0, 0.0, 1.0);
}
