// How a solid's fragment is kept. PASS 0 keeps what fills its pixel; PASS 1 the nearest fragment that fills only
// part of it; PASS 2 the next one behind that. The composite puts them together in order of depth.
out vec4 fragment;
#if PASS == 2
uniform sampler2D nearestEdgeDepth;
#endif

// An edge must be this much farther to be another edge and not the same one again.
const float kSameDepth = 1e-6;

void emit(vec3 color, float coverage, float depth) {
#if PASS == 0
  if (coverage < 0.998) discard;
  fragment = vec4(color, 1.0);
#else
  if (coverage < 0.002 || coverage >= 0.998) discard;
#if PASS == 2
  if (depth <= texelFetch(nearestEdgeDepth, ivec2(gl_FragCoord.xy), 0).r + kSameDepth) discard;
#endif
  fragment = vec4(color, coverage);
#endif
  gl_FragDepth = depth;
}
