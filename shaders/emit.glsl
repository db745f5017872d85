// SPDX-License-Identifier: Apache-2.0
// How a solid's fragment is kept. EDGES 0 keeps what fills its pixel; EDGES 1 the nearest fragment that fills only part
// of it and lies behind the edge found before (none in the first edge pass: nothing is bound then, which reads as 0).
// The composite puts them together in order of depth.
out vec4 fragment;
#if EDGES
uniform sampler2D edgeBefore;
#endif

// An edge must be this much farther to be another edge and not the same one again.
const float kSameDepth = 1e-6;

void emit(vec3 color, float coverage, float depth) {
#if EDGES
  if (coverage < 0.002 || coverage >= 0.998) discard;
  if (depth <= texelFetch(edgeBefore, ivec2(gl_FragCoord.xy), 0).r + kSameDepth) discard;
  fragment = vec4(color, coverage);
#else
  if (coverage < 0.998) discard;
  fragment = vec4(color, 1.0);
#endif
  gl_FragDepth = depth;
}
