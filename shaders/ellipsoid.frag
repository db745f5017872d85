// SPDX-License-Identifier: Apache-2.0
#include "camera.glsl"
#include "coverage.glsl"
#include "graticule.glsl"
#include "shading.glsl"
#include "emit.glsl"

uniform vec3 centre_C;
uniform mat3 toUnitSphere;  // inverse of the semi-axis matrix
uniform vec2 outlineCentre_px;
uniform vec3 outlineForm;
uniform float solid;
uniform vec3 color;
uniform float gloss;
uniform vec4 marking;  // colour of the lines on it, and their width in px (0: none)

void main() {
  vec2 p_px = gl_FragCoord.xy;
  float coverage = covered(edgeAt(ScreenEllipse(outlineCentre_px, outlineForm), p_px));
  vec3 ray = rayThrough(p_px), toCentre_C = centre_C - rayFrom(p_px);
  // From the point of the ray nearest the centre, so that no large numbers cancel.
  float t0 = dot(toCentre_C, ray) / dot(ray, ray);
  vec3 o = toUnitSphere * (t0 * ray - toCentre_C), d = toUnitSphere * ray;
  float a = dot(d, d), along = dot(o, d) / a;
  vec3 offset = o - along * d;
  float t = t0 - along - sqrt(max(1.0 - dot(offset, offset), 0.0) / a);
  vec3 s = o + (t - t0) * d;
  vec3 n_C = normalize(s * toUnitSphere);  // transpose(inverse) of the semi-axes, times s
  float size = pixelSize(t);
  vec3 dx = changeOnSphere(s, d, size * toUnitSphere[0]), dy = changeOnSphere(s, d, -size * toUnitSphere[1]);
  float lines = marking.a > 0.0 ? markings(s, dx, dy, marking.a) : 0.0;
  emit(solid, shade(Material(mix(color, marking.rgb, lines), gloss), n_C, -normalize(ray)), coverage, toDepth(t));
}
