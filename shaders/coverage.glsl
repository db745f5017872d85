// SPDX-License-Identifier: Apache-2.0
// Analytic coverage: how much of a pixel lies inside a boundary at signed distance d_px (positive inside).

// A straight edge as a pixel sees it: xy the unit vector towards the inside, z the distance of the pixel's centre.
// The area is exact: a triangle until the edge has passed a corner of the pixel, then a trapezium.
float covered(vec3 edge) {
  vec2 n = abs(edge.xy);
  float a = max(n.x, n.y), b = max(min(n.x, n.y), 1e-4);
  float d = edge.z * sharpness;
  float beyond = max(0.5 * (a + b) - abs(d), 0.0);  // what the edge has still to go to leave the pixel
  float smaller = beyond < b ? beyond * beyond / (2.0 * a * b) : (beyond - 0.5 * b) / a;
  return d > 0.0 ? 1.0 - smaller : smaller;
}

// A strip between two parallel edges, right also where it is thinner than a pixel.
float coveredStrip(vec3 a, vec3 b) { return max(covered(a) + covered(b) - 1.0, 0.0); }

// A line, by its unit normal and the distance of its middle.
float coveredLine(float distance_px, vec2 normal, float width_px) {
  return coveredStrip(vec3(-normal, 0.5 * width_px - distance_px), vec3(normal, 0.5 * width_px + distance_px));
}

// A thin line of low contrast: a ramp one pixel wide, whose second moment is that of the pixel in every direction.
// Exact where the line is level or upright, and a fifth of the cost.
float faintLine(float distance_px, float width_px) {
  float width = width_px * sharpness;
  return clamp(0.5 * width + 0.5 - distance_px * sharpness, 0.0, min(width, 1.0));
}

// Which share of the pixel lies on the near side of where two surfaces cut each other: `ahead` is how much farther the
// other one is, and slope how fast that grows.
float shareBefore(float ahead, vec2 slope) {
  slope.x += 1e-9;  // a direction, where the surfaces are parallel
  return covered(vec3(slope, ahead) / length(slope));
}

// The same of glass and a solid, as of a faint line.
float glassBefore(float ahead, vec2 slope) {
  return clamp(0.5 + sharpness * ahead * inversesqrt(dot(slope, slope) + 1e-18), 0.0, 1.0);
}

// An ellipse in the picture: centre and inverse covariance (xx, xy, yy), rho = 1 on its edge. rho grows
// linearly from the centre, so that the first-order distance is exact for a circle.
struct ScreenEllipse {
  vec2 centre_px;
  vec3 form;
};

// Half its width where it is narrowest across.
float halfWidth(ScreenEllipse e) {
  float difference = 0.5 * (e.form.x - e.form.z);
  return inversesqrt(0.5 * (e.form.x + e.form.z) + length(vec2(difference, e.form.y)));
}

// The straight edge nearest like it. Nothing inside is farther from the edge than half the width.
vec3 edgeAt(ScreenEllipse e, vec2 p_px) {
  vec2 q = p_px - e.centre_px;
  vec2 g = vec2(e.form.x * q.x + e.form.y * q.y, e.form.y * q.x + e.form.z * q.y);
  float rho = sqrt(max(dot(q, g), 1e-12)), slope = max(length(g), 1e-12);
  return vec3(-g / slope, min((1.0 - rho) * rho / slope, halfWidth(e)));
}

// Right also where it is thinner than a pixel.
float covered(ScreenEllipse e, vec2 p_px) {
  vec3 edge = edgeAt(e, p_px);
  return coveredStrip(edge, vec3(-edge.xy, 2.0 * halfWidth(e) - edge.z));
}

// A line (a, b, c): a x + b y + c, (a, b) a unit vector towards the inside.
vec3 edgeAt(vec3 line, vec2 p_px) { return vec3(line.xy, dot(line.xy, p_px) + line.z); }

// The edge that is farther in, and the one that is farther out.
vec3 innerOf(vec3 a, vec3 b) { return a.z > b.z ? a : b; }
vec3 outerOf(vec3 a, vec3 b) { return a.z > b.z ? b : a; }

// A convex quadrilateral whose opposite edges are 0, 2 and 1, 3.
float coveredQuad(vec3 e0, vec3 e1, vec3 e2, vec3 e3, vec2 p_px) {
  return coveredStrip(edgeAt(e0, p_px), edgeAt(e2, p_px)) * coveredStrip(edgeAt(e1, p_px), edgeAt(e3, p_px));
}

// Integral of what lies to the right of x within a pixel 1 wide.
float roomRightOf(float x) { return x < 0.0 ? x : (x < 1.0 ? x - 0.5 * x * x : 0.5); }

// The area of the pixel to the right of a side of a polygon, negative for sides that go up: all sides together give
// the exact area of the polygon, however thin it is.
float areaRightOf(vec2 from_px, vec2 to_px, vec2 p_px) {
  vec2 a = (from_px - p_px) * sharpness + 0.5, b = (to_px - p_px) * sharpness + 0.5;
  float ya = clamp(a.y, 0.0, 1.0), yb = clamp(b.y, 0.0, 1.0), slope = (b.x - a.x) / (a.y == b.y ? 1.0 : b.y - a.y);
  float xa = a.x + (ya - a.y) * slope, xb = a.x + (yb - a.y) * slope, width = xb - xa;
  float room = abs(width) > 1e-3 ? (roomRightOf(xb) - roomRightOf(xa)) / width : clamp(1.0 - 0.5 * (xa + xb), 0.0, 1.0);
  return (yb - ya) * room;
}
