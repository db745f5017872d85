// SPDX-License-Identifier: Apache-2.0
// Lines on a sphere s (unit vectors), drawn on whatever ellipsoid it was made from. dx and dy: how s changes from pixel
// to pixel, to the right and down.

// That change, where the sphere is looked at along d and a step in the picture is `across` there. Not from the
// neighbours' difference, which is too coarse at the rim.
vec3 changeOnSphere(vec3 s, vec3 d, vec3 across) {
  float facing = dot(s, d);
  return across - d * dot(s, across) / (facing < 0.0 ? min(facing, -1e-4) : max(facing, 1e-4));
}

// A line where `value` is 0; `slope` is how fast that grows to the right and down, per pixel.
float lineCover(float value, vec2 slope, float width_px) {
  float steepness = max(length(slope), 1e-9), distance_px = value / steepness;
  vec2 across = slope / steepness;
  return coveredStrip(vec3(-across, 0.5 * width_px - distance_px), vec3(across, 0.5 * width_px + distance_px));
}

// One family of lines at every `step` of an angle, fading where they come closer than `least_px`.
float graticuleLines(float angle, vec2 slope, float step, float width_px, float least_px) {
  float spacing_px = step / max(length(slope), 1e-9);
  float fade = clamp(2.0 * spacing_px / least_px - 1.0, 0.0, 1.0);
  return fade * lineCover(angle - step * round(angle / step), slope, width_px);
}

// Latitude and longitude of s, and how fast they change, per pixel to the right and down.
struct Angles {
  float latitude, longitude;
  vec2 latitudeSlope, longitudeSlope;
};

Angles anglesOf(vec3 s, vec3 dx, vec3 dy) {
  float r2 = max(dot(s.xy, s.xy), 1e-8);
  return Angles(atan(s.z, sqrt(r2)), atan(s.y, s.x), vec2(dx.z, dy.z) / sqrt(r2),
                vec2(s.x * dx.y - s.y * dx.x, s.x * dy.y - s.y * dy.x) / r2);
}

// On glass: parallels every 15 degrees; meridians every 30, and every 15 where there is room, so that they fade out
// towards the poles and do not crowd there. The three principal sections are drawn stronger.
float graticule(vec3 s, vec3 dx, vec3 dy, float width_px) {
  const float kStep = 0.2617993878;  // 15 degrees
  Angles a = anglesOf(s, dx, dy);
  float room_px = 12.0 * width_px;
  float minor = max(graticuleLines(a.latitude, a.latitudeSlope, kStep, width_px, 0.5 * room_px),
                    max(graticuleLines(a.longitude, a.longitudeSlope, 2.0 * kStep, width_px, 0.5 * room_px),
                        graticuleLines(a.longitude, a.longitudeSlope, kStep, width_px, 2.5 * room_px)));
  float principal = max(lineCover(a.latitude, a.latitudeSlope, width_px),
                        graticuleLines(a.longitude, a.longitudeSlope, 6.0 * kStep, width_px, 0.25 * room_px));
  return max(principal, 0.55 * minor);
}

// On a solid: rings every 22.5 degrees, four meridians, one of them heavy: without it the spin of a round body would
// not show.
float markings(vec3 s, vec3 dx, vec3 dy, float width_px) {
  const float kRing = 0.3926990817, kQuarter = 1.570796327;
  Angles a = anglesOf(s, dx, dy);
  float rings = graticuleLines(a.latitude, a.latitudeSlope, kRing, width_px, 4.0 * width_px);
  float meridians = graticuleLines(a.longitude, a.longitudeSlope, kQuarter, width_px, 3.0 * width_px);
  float heavy = lineCover(a.longitude, a.longitudeSlope, 2.2 * width_px);
  return max(heavy, max(rings, meridians));
}
