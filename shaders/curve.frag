// SPDX-License-Identifier: Apache-2.0
#include "constants.glsl"
#include "camera.glsl"
#include "coverage.glsl"
#include "shading.glsl"
#include "emit.glsl"

noperspective in vec4 acrossOut;
noperspective in vec4 tangentOut_C;

void main() {
  Material material = Material(own(0).rgb, own(0).a);
  float solid = own(1).x, lift = own(1).y;  // lift: distance towards the eye
  float offset = acrossOut.x, halfWidth = acrossOut.y;
  // `offset` is linear over a piece, so its derivatives give the exact direction of the piece.
  vec2 inwards = -normalize(vec2(dFdx(offset), dFdy(offset)) + vec2(1e-9, 0.0));
  float coverage = coveredStrip(vec3(inwards, halfWidth - offset), vec3(-inwards, halfWidth + offset));
  coverage *= covered(vec3(inwards.yx, acrossOut.z));
  float t = acrossOut.w;
#if TUBE
  float u = clamp(offset / max(halfWidth, 1e-6), -1.0, 1.0), front = sqrt(1.0 - u * u);
  vec3 ray = normalize(rayThrough(place_px));
  vec3 side_C = normalize(cross(tangentOut_C.xyz, ray) + vec3(1e-9));
  vec3 shown = shade(material, u * side_C - front * ray, -ray);  // lit as if the curve lay across the view
  t -= front * tangentOut_C.w;
#else
  vec3 shown = material.color;
#endif
  emit(solid, shown, coverage, toDepth(t - lift));
}
