// SPDX-License-Identifier: Apache-2.0
// Camera axes C: x right, y up, looking along -z. Pixels count from the top left corner, y down, and row 0 of the
// framebuffer is the top row, so that nothing is flipped on read-back.

// The ray through a pixel is x_C = rayFrom + t * rayThrough, where t is the distance along the view.
vec3 rayThrough(vec2 p_px) {
  vec2 q = (p_px - opticalCentre_px) * (pixelAtOne * (1.0 - orthographic));
  return vec3(q.x, -q.y, -1.0);
}

vec3 rayFrom(vec2 p_px) {
  vec2 q = (p_px - opticalCentre_px) * (pixelAtOne * orthographic);
  return vec3(q.x, -q.y, 0.0);
}

// Returns the length of a pixel's side at distance t along the view.
float pixelSize(float t) { return mix(t, 1.0, orthographic) * pixelAtOne; }

float toDepth(float t) { return clamp((t - depthRange.x) * depthRange.y, 0.0, 1.0); }
