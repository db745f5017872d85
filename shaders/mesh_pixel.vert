// SPDX-License-Identifier: Apache-2.0
// Shades one pixel of a mesh that the CPU resolved: up to four directions of surface, each with its share.
#include "constants.glsl"
#include "camera.glsl"
#include "shading.glsl"

const int kFacets = 4;

layout(location = 0) in vec4 place;                // centre in pixels, coverage, distance along the view
layout(location = 1) in vec4 normals_C[kFacets];   // unit; w: share
layout(location = 5) in vec4 materials[kFacets];   // colour, gloss

layout(location = 9) in float solid;

flat out vec4 shown;
flat out float depth;
flat out float solidOut;

void main() {
  handOn();
  vec3 towardEye_C = -normalize(rayThrough(place.xy));
  vec3 sum = vec3(0.0);
  for (int i = 0; i < kFacets; ++i) {
    if (normals_C[i].w <= 0.0) break;
    vec3 n_C = turnedToEye(normals_C[i].xyz, towardEye_C);
    // Each direction is clamped separately, as the buffers clamp a surface that fills a pixel.
    vec3 light = min(shade(Material(materials[i].rgb, materials[i].a), n_C, towardEye_C), 1.0);
    sum += normals_C[i].w * light;
  }
  shown = vec4(sum, place.z);
  solidOut = solid;
  depth = toDepth(place.w);
  gl_PointSize = 1.0;
  gl_Position = vec4(2.0 * place.xy / pictureSize_px - 1.0, 0.0, 1.0);
}
