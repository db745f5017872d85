// SPDX-License-Identifier: Apache-2.0
#include "camera.glsl"
#include "coverage.glsl"
#include "shading.glsl"
#include "emit.glsl"

// The inside of a mesh's faces. Pixels that an edge runs through are marked: mesh_pixel.vert draws those.
uniform sampler2D marks;
uniform float solid;
uniform vec3 color;
uniform float gloss;

in vec3 normalOut_C;
in float distanceOut;

void main() {
  float inside = float(texelFetch(marks, ivec2(gl_FragCoord.xy), 0).r < 0.5);
  vec3 towardEye_C = -normalize(rayThrough(gl_FragCoord.xy));
  vec3 n_C = turnedToEye(normalize(normalOut_C), towardEye_C);
  float t = mix(1.0 / gl_FragCoord.w, distanceOut, orthographic);
  emit(solid, shade(Material(color, gloss), n_C, towardEye_C), inside, toDepth(t));
}
