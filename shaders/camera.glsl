// SPDX-License-Identifier: Apache-2.0
// C: camera axes, x right, y up, looking along -z. Pixels count from the top left corner, y down, and row 0 of the
// framebuffer is the top row, so that nothing is flipped on read-back.
uniform vec2 pictureSize_px;
uniform vec2 opticalCentre_px;
uniform float focal_px;
uniform vec2 depthRange;  // nearest and farthest distance along the view

// The ray through a pixel: x_C = t * ray, t being the distance along the view.
vec3 rayThrough(vec2 p_px) {
  vec2 q = (p_px - opticalCentre_px) / focal_px;
  return vec3(q.x, -q.y, -1.0);
}

float toDepth(float t) { return clamp((t - depthRange.x) / (depthRange.y - depthRange.x), 0.0, 1.0); }
