// SPDX-License-Identifier: Apache-2.0
#include "constants.glsl"
#include "camera.glsl"
#include "coverage.glsl"
#include "shading.glsl"
#include "emit.glsl"

// Draws the insides of a mesh's faces. Pixels that an edge crosses are marked, and mesh_pixel.vert draws them.
uniform sampler2DRect marks;

in vec3 normalOut_C;
in float distanceOut;

void main() {
  float inside = float(texelFetch(marks, ivec2(place_px)).r < 0.5);
  vec3 towardEye_C = -normalize(rayThrough(place_px));
  vec3 n_C = turnedToEye(normalize(normalOut_C), towardEye_C);
  float t = mix(1.0 / gl_FragCoord.w, distanceOut, orthographic);
  emit(own(0).w, shade(Material(own(7).rgb, own(7).a), n_C, towardEye_C), inside, toDepth(t));
}
