// SPDX-License-Identifier: Apache-2.0
#include "constants.glsl"
#include "camera.glsl"
#include "coverage.glsl"
#include "shading.glsl"
#include "emit.glsl"

// The picture of a frustum is the hull of its two end discs: two ellipses and the strip between their tangents. A chord is
// the strip's edge across, at a disc.
// Reports whether a disc is seen almost edge-on and has a chord. Pixels are then wider than the part of the disc beyond
// the chord.
bool isThin(ScreenEllipse disc, vec3 chord) { return halfWidth(disc) < 2.0 && abs(chord.z) < 1e5; }

// Returns the edge across the strip at a disc: the chord, or the outline of the disc itself if the disc is thin.
vec3 endAt(ScreenEllipse disc, vec3 chord, vec2 p_px) {
  if (!isThin(disc, chord)) return edgeAt(chord, p_px);
  vec2 n = chord.xy, q = p_px - disc.centre_px;
  vec2 g = vec2(disc.form.x * n.x + disc.form.y * n.y, disc.form.y * n.x + disc.form.z * n.y);
  float a = dot(n, g), b = dot(q, g);
  float c = disc.form.x * q.x * q.x + 2.0 * disc.form.y * q.x * q.y + disc.form.z * q.y * q.y - 1.0;
  return vec3(n, (b + sqrt(max(b * b - a * c, 0.0))) / a);
}

void main() {
  vec2 p_px = place_px;
  vec3 from_C = own(0).xyz, axis_C = own(1).xyz;  // unit axis from the first disc to the second
  float solid = own(0).w, gloss = own(4).w;
  int visibleCap = int(own(1).w);                 // 0: none, 1: first disc, 2: second
  vec4 radii = own(2);                            // first, second, height, slope (second - first) / height
  ScreenEllipse firstDisc = ScreenEllipse(own(3).xy, own(4).xyz);
  ScreenEllipse secondDisc = ScreenEllipse(own(3).zw, own(5).xyz);
  vec3 color = own(6).rgb;
  // Edges of the strip; 0 and 2 are the silhouette. All are (0, 0, -1e6) if there is no strip.
  vec3 sides[4] = vec3[4](own(7).xyz, own(8).xyz, own(9).xyz, own(10).xyz);
  vec3 first = edgeAt(firstDisc, p_px), second = edgeAt(secondDisc, p_px);
  vec3 ends = outerOf(endAt(secondDisc, sides[1], p_px), endAt(firstDisc, sides[3], p_px));
  vec3 strip = outerOf(outerOf(edgeAt(sides[0], p_px), edgeAt(sides[2], p_px)), ends);
  vec3 outline = strip;  // includes thin discs
  if (!isThin(firstDisc, sides[3])) outline = innerOf(outline, first);
  if (!isThin(secondDisc, sides[1])) outline = innerOf(outline, second);
  float whole = covered(outline);
  // Also right at the tip, where both silhouettes run through one pixel.
  if (sides[0].z > -1e5) whole = min(whole, coveredStrip(edgeAt(sides[0], p_px), edgeAt(sides[2], p_px)));
  float cap = visibleCap == 0 ? 0.0 : covered(visibleCap == 1 ? firstDisc : secondDisc, p_px);

  vec3 ray = rayThrough(p_px), towardEye_C = -normalize(ray);
  vec3 toFirst_C = from_C - rayFrom(p_px);
  float t0 = dot(toFirst_C, ray) / dot(ray, ray);
  vec3 o = t0 * ray - toFirst_C;  // from the first centre to the nearest point of the ray
  float du = dot(ray, axis_C), ou = dot(o, axis_C), slope = radii.w, kk = 1.0 + slope * slope;
  float a = dot(ray, ray) - kk * du * du;
  float b = dot(ray, o) - kk * du * ou - slope * radii.x * du;
  float c = dot(o, o) - kk * ou * ou - 2.0 * slope * radii.x * ou - radii.x * radii.x;
  float root = sqrt(max(b * b - a * c, 0.0));
  // The nearer of the two roots, without cancellation. `a` changes sign if the eye looks into the cone.
  float q = b > 0.0 ? -b - root : -b + root;
  float r1 = q / a, r2 = abs(q) > 1e-20 ? c / q : r1;
  float near = min(r1, r2), far = max(r1, r2);
  float s = ou + near * du;
  bool nearIsOn = s > -0.02 * radii.z && s < 1.02 * radii.z && radii.x + slope * s > -1e-3 * max(radii.x, radii.y);
  float tSide = nearIsOn ? near : far;
  float height = clamp(ou + tSide * du, 0.0, radii.z);
  vec3 radial = o + tSide * ray - (ou + tSide * du) * axis_C;
  vec3 nSide_C = turnedToEye(normalize(normalize(radial + 1e-12 * towardEye_C) - slope * axis_C), towardEye_C);

  float capHeight = visibleCap == 2 ? radii.z : 0.0;
  float tCap = (capHeight - ou) / (abs(du) > 1e-6 ? du : 1e-6);
  vec3 nCap_C = visibleCap == 2 ? axis_C : -axis_C;

  Material material = Material(color, gloss);
  vec3 sideColor = shade(material, nSide_C, towardEye_C), capColor = shade(material, nCap_C, towardEye_C);
  float capShare = whole > 0.0 ? min(cap / whole, 1.0) : 0.0;
  // Outside the sharp silhouette the roots mean nothing. The depth of the axis is good enough to order edges.
  float t = t0 + (capShare > 0.5 ? tCap : tSide);
  float size = max(max(radii.x, radii.y), 1e-6);
  float tAxis = t0 + dot(toFirst_C + clamp(ou, 0.0, radii.z) * axis_C - t0 * ray, ray) / dot(ray, ray);
  t = clamp(t, tAxis - radii.z - size, tAxis + radii.z + size);
  emit(solid, mix(sideColor, capColor, capShare), whole, toDepth(t));
}
