// SPDX-License-Identifier: Apache-2.0
// How a solid's fragment is kept. EDGES 0 keeps what fills its pixel; EDGES 1 the nearest fragment that fills only part
// of it and lies behind the edge found before (none in the first edge pass: nothing is bound then, which reads as 0);
// EDGES 2 what fills its pixel behind another solid, but comes forward within it, as the two cut each other there.
// The composite puts them together in order of depth. EDGES 2 wants coverage.glsl before.
#if EDGES > 0
#include "kept_edge.glsl"
#endif
out vec4 fragment;
#if EDGES == 1
uniform sampler2DRect edgeBefore;
#elif EDGES == 2
uniform sampler2DRect fullColor, fullDepth;  // alpha: the solid's number
#endif

// Where a solid's fragment is in the picture. Texels of the layers themselves are at gl_FragCoord.
#define place_px (gl_FragCoord.xy + layers_px)

// An edge must be this much farther to be another edge and not the same one again.
const float kSameDepth = 1e-6;
const float kNumber = 1.0 / 65535.0;

#if EDGES == 2
bool isSame(float a, float b) { return abs(a - b) < 0.5 * kNumber; }

// Whether that solid is there; where the depth is 1 nothing is, and the colour is of a picture before.
bool isThere(ivec2 texel, float depth, float number) {
  return depth < 1.0 && isSame(texelFetch(fullColor, texel).a, number);
}

// How the depth of the solid in front grows in the direction of `step`, as far as that solid reaches.
float slopeInFront(ivec2 texel, ivec2 step, float depth, float number) {
  float depthBefore = texelFetch(fullDepth, texel - step).r, depthAfter = texelFetch(fullDepth, texel + step).r;
  float before = depth - depthBefore, after = depthAfter - depth;
  bool isBefore = isThere(texel - step, depthBefore, number);
  bool isAfter = isThere(texel + step, depthAfter, number);
  float flatter = abs(before) < abs(after) ? before : after;
  return isBefore ? (isAfter ? flatter : before) : (isAfter ? after : 0.0);
}
#endif

// `solid` is its number, of 65535; 1: it has no seams, as a flat line. Light brighter than white is kept as white,
// in floats as in 16 bits, or its edges would be jagged.
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
