// SPDX-License-Identifier: Apache-2.0
// Lines on a sphere s (unit vectors), drawn on the ellipsoid that the sphere stands for. No angle is computed: latitude
// and longitude are unit complex numbers, and lines at equal steps of an angle are where the imaginary part of a power is
// zero. Away from the lines this part is a sine, which makes the distance too short, but only where lines are so close
// that they have faded.

vec2 timesComplex(vec2 a, vec2 b) { return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x); }
vec2 squareComplex(vec2 a) { return vec2(a.x * a.x - a.y * a.y, 2.0 * a.x * a.y); }

// Point of the sphere, as seen in the picture.
struct SpherePoint {
  vec2 latitude;        // unit complex number
  vec2 twiceLongitude;  // unit complex number of twice the angle
  vec2 pixels;          // pixels per radian of latitude and of longitude
  vec2 north, east;     // unit directions in the picture
};

// dx and dy are the changes of s from pixel to pixel, to the right and down.
SpherePoint spherePoint(vec3 s, vec3 dx, vec3 dy) {
  vec2 up = vec2(dx.z, dy.z), around = vec2(s.x * dx.y - s.y * dx.x, s.x * dy.y - s.y * dy.x);
  float r2 = max(dot(s.xy, s.xy), 1e-8), r = sqrt(r2);
  float climb = sqrt(dot(up, up) + 1e-18), turn = sqrt(dot(around, around) + 1e-18);
  float inverse = 1.0 / (climb * turn * r2);  // one division instead of three
  return SpherePoint(vec2(r, s.z), squareComplex(s.xy) * (inverse * climb * turn),
                     vec2(r * r2 * turn * inverse, r2 * r2 * climb * inverse), up * (turn * r2 * inverse),
                     around * (climb * r2 * inverse));
}

// Returns how much is left of a family of lines that fades when the lines are closer than `least` widths.
float fade(float spacing_px, vec2 width_px, float least) {
  return clamp(spacing_px * (2.0 / least * width_px.y) - 1.0, 0.0, 1.0);
}

// Returns the coverage by lines on glass: parallels every 15 degrees; meridians every 30 degrees, and every 15 where there
// is room, so that they fade out towards the poles instead of crowding there. The three principal sections are stronger.
// Widths come with their reciprocals.
float graticule(SpherePoint p, vec2 width_px) {
  const float kStep = 0.2617993878;
  vec2 u2 = squareComplex(p.latitude), u6 = timesComplex(u2, squareComplex(u2));
  vec2 v2 = p.twiceLongitude, v6 = timesComplex(v2, squareComplex(v2));
  const float kSixth = 1.0 / 6.0;
  float parallel = kSixth * abs(u6.x * u6.y), meridian = kSixth * abs(v6.x * v6.y);  // sines of 12 times the angles
  float step_px = kStep * p.pixels.y;
  float minor = max(fade(kStep * p.pixels.x, width_px, 6.0) * faintLine(parallel * p.pixels.x, width_px.x),
                    max(fade(2.0 * step_px, width_px, 6.0) * faintLine(kSixth * abs(v6.y) * p.pixels.y, width_px.x),
                        fade(step_px, width_px, 30.0) * faintLine(meridian * p.pixels.y, width_px.x)));
  float principal = max(faintLine(abs(p.latitude.y) * p.pixels.x, width_px.x),
                        fade(6.0 * step_px, width_px, 3.0) * faintLine(0.5 * abs(v2.y) * p.pixels.y, width_px.x));
  return max(principal, 0.55 * minor);
}

// Returns the coverage by lines on a solid: rings every 22.5 degrees and four meridians. The one on the side of `ahead` is
// heavy, because the spin of a round body would not show otherwise.
float markings(SpherePoint p, vec2 width_px, bool ahead) {
  const float kRing = 0.3926990817, kQuarter = 1.570796327;
  vec2 u4 = squareComplex(squareComplex(p.latitude));
  float ring = 0.25 * abs(u4.x * u4.y), meridian = 0.5 * abs(p.twiceLongitude.y);  // sines of 8 times and twice the angles
  float rings = coveredLine(ring * p.pixels.x, p.north, width_px.x) * fade(kRing * p.pixels.x, width_px, 4.0);
  float meridian_px = meridian * p.pixels.y;
  float meridians = coveredLine(meridian_px, p.east, width_px.x) * fade(kQuarter * p.pixels.y, width_px, 3.0);
  // Twice the longitude is 0 if the longitude is 0 or half a turn.
  bool about = p.twiceLongitude.x > 0.0 && ahead;
  float heavy = float(about) * coveredLine(meridian_px, p.east, 2.2 * width_px.x);
  return max(heavy, max(rings, meridians));
}
