// SPDX-License-Identifier: Apache-2.0
#include "constants.glsl"
#include "camera.glsl"
#include "coverage.glsl"
#include "graticule.glsl"
#include "ray_ellipsoid.glsl"
#include "shading.glsl"
#include "emit.glsl"

void main() {
  vec2 p_px = place_px;
  RayEllipsoid e = rayEllipsoid(0);
  float solid = own(9).x, gloss = own(9).y;
  vec3 color = own(10).rgb;
  vec4 marking = own(11);  // colour of the lines on the ellipsoid, and their width in px (0: none)

  float coverage = covered(edgeAt(e.outline, p_px));
  Chord chord = chordOf(e, p_px);
  vec3 ray = rayThrough(p_px);
  ChordEnd near = endOf(e, chord, -1.0, dot(ray, ray));
  float t = e.distance + near.t;
  SpherePoint place = spherePoint(e, chord, near, pixelSize(t));
  float lines = marking.a > 0.0 ? markings(place, vec2(marking.a, 1.0 / marking.a), near.onSphere.x > 0.0) : 0.0;
  vec3 towardEye_C = -normalize(ray);
  vec3 shown = shade(Material(mix(color, marking.rgb, lines), gloss), normalize(near.normal_C), towardEye_C);
  emit(solid, shown, coverage, toDepth(t));
}
