// SPDX-License-Identifier: Apache-2.0
// Tiles of the picture, two triangles each.
uniform vec2 pictureSize_px;

layout(location = 0) in vec2 position_px;

void main() { gl_Position = vec4(2.0 * position_px / pictureSize_px - 1.0, 0.0, 1.0); }
