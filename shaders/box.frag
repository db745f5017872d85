// SPDX-License-Identifier: Apache-2.0
#include "camera.glsl"
#include "coverage.glsl"
#include "shading.glsl"
#include "emit.glsl"

// The faces that look at the eye, three at most; the edges of a missing one have nothing inside. They lie side by
// side in the picture: their coverages add up.
uniform vec3 edges[12];      // four to a face, towards its inside
uniform vec3 normals_C[3];
uniform vec3 points_C[3];    // a point of each face
uniform vec3 color;
uniform float gloss;

void main() {
  vec2 p_px = gl_FragCoord.xy;
  vec3 ray = rayThrough(p_px), towardEye_C = -normalize(ray);
  Material material = Material(color, gloss);
  vec3 sum = vec3(0.0);
  float whole = 0.0, largest = 0.0, t = depthRange.y;
  for (int i = 0; i < 3; ++i) {
    float share = coveredQuad(edges[4 * i], edges[4 * i + 1], edges[4 * i + 2], edges[4 * i + 3], p_px);
    float tFace = dot(normals_C[i], points_C[i]) / min(dot(normals_C[i], ray), -1e-6);
    sum += share * shade(material, normals_C[i], towardEye_C);
    whole += share;
    if (share > largest) {
      largest = share;
      t = tFace;
    }
  }
  emit(sum / max(whole, 1e-6), min(whole, 1.0), toDepth(t));
}
