// SPDX-License-Identifier: Apache-2.0
// Functions that the translucent sheets share. Colours are premultiplied: rgb times opacity.

vec4 layOver(vec4 over, vec4 under) { return over + under * (1.0 - over.a); }

vec4 premultiplied(vec3 color, float opacity) { return vec4(color * opacity, opacity); }
vec4 premultiplied(vec4 straight) { return premultiplied(straight.rgb, straight.a); }

// Returns the coverage to use for the far wall of a body, so that the wall appears with its own coverage behind the near
// wall. The two walls end at one outline. If they were taken as independent, the outline would come out too dark.
float behindNear(float farCover, float nearCover, float nearOpacity) {
  return (farCover - min(farCover, nearCover) * nearOpacity) / max(1.0 - nearCover * nearOpacity, 1e-6);
}
