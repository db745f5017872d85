// SPDX-License-Identifier: Apache-2.0
// Decides which fragments of solids a pass keeps. EDGES 0 keeps fragments that fill their pixel. EDGES 1 keeps the nearest
// fragment that fills only part of its pixel and lies behind the edge found before (in the first edge pass nothing is
// bound, which reads as 0). EDGES 2 keeps fragments that fill their pixel behind another solid, but come forward within it
// because the two cut each other there. The composite pass puts all of them together in order of depth. EDGES 2 needs
// coverage.glsl before this file.
#if EDGES > 0
#include "kept_edge.glsl"
#endif
out vec4 fragment;
#if EDGES == 1
uniform sampler2DRect edgeBefore;
#elif EDGES == 2
uniform sampler2DRect fullColor, fullDepth;  // alpha: number of the solid
#endif

// Position of a fragment in the picture. Texels of the layers themselves are at gl_FragCoord.
#define place_px (gl_FragCoord.xy + layers_px)

// An edge must be farther than the previous one by this depth, or it counts as the same edge.
const float kSameDepth = 1e-6;
const float kNumber = 1.0 / 65535.0;

#if EDGES == 2
bool isSame(float a, float b) { return abs(a - b) < 0.5 * kNumber; }

// Reports whether the solid `number` is at a texel. Where the depth is 1 there is no solid, and the colour is stale.
bool isThere(ivec2 texel, float depth, float number) {
  return depth < 1.0 && isSame(texelFetch(fullColor, texel).a, number);
}

// Returns how the depth of the solid in front grows in the direction of `step`, as far as that solid reaches.
float slopeInFront(ivec2 texel, ivec2 step, float depth, float number) {
  float depthBefore = texelFetch(fullDepth, texel - step).r, depthAfter = texelFetch(fullDepth, texel + step).r;
  float before = depth - depthBefore, after = depthAfter - depth;
  bool isBefore = isThere(texel - step, depthBefore, number);
  bool isAfter = isThere(texel + step, depthAfter, number);
  float flatter = abs(before) < abs(after) ? before : after;
  return isBefore ? (isAfter ? flatter : before) : (isAfter ? after : 0.0);
}
#endif

// Writes a fragment. `solid` is the solid's number divided by 65535; number 1 has no seams, such as a flat line. Light
// brighter than white is kept as white, in floats as in 16 bits, or its edges would be jagged.
void emit(float solid, vec3 color, float coverage, float depth) {
  color = min(color, 1.0);
#if EDGES == 2
  vec2 slope = vec2(dFdx(depth), dFdy(depth));
  ivec2 texel = ivec2(gl_FragCoord.xy);
  float number = texelFetch(fullColor, texel).a, inFront = texelFetch(fullDepth, texel).r;
  if (coverage < 0.998 || inFront == 1.0 || number < 1.5 * kNumber || isSame(number, solid)) discard;
  vec2 other = vec2(slopeInFront(texel, ivec2(1, 0), inFront, number), slopeInFront(texel, ivec2(0, 1), inFront, number));
  float share = shareBefore(inFront - depth, other - slope);
  if (share < 0.002) discard;
  fragment = vec4(color, keptEdge(share, false));
  gl_FragDepth = inFront;
#elif EDGES == 1
  if (coverage < 0.002 || coverage >= 0.998) discard;
  if (depth <= texelFetch(edgeBefore, ivec2(gl_FragCoord.xy)).r + kSameDepth) discard;
  fragment = vec4(color, keptEdge(coverage, solid < 1.5 * kNumber));
  gl_FragDepth = depth;
#else
  if (coverage < 0.998) discard;
  fragment = vec4(color, solid);
  gl_FragDepth = depth;
#endif
}
