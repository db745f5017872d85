// SPDX-License-Identifier: Apache-2.0
// What the translucent sheets share. Colours are premultiplied: rgb times opacity.

// `over` laid on `under`.
vec4 layOver(vec4 over, vec4 under) { return over + under * (1.0 - over.a); }

vec4 premultiplied(vec3 color, float opacity) { return vec4(color * opacity, opacity); }
vec4 premultiplied(vec4 straight) { return premultiplied(straight.rgb, straight.a); }

// The coverage to give the far wall of a body, so that behind the near one (of that opacity) it has its own. The two
// end at one outline: were they taken for independent, the outline would come out too dark.
float behindNear(float farCover, float nearCover, float nearOpacity) {
  return (farCover - min(farCover, nearCover) * nearOpacity) / max(1.0 - nearCover * nearOpacity, 1e-6);
}
