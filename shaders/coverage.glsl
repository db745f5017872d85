// SPDX-License-Identifier: Apache-2.0
// Analytic coverage: the share of a pixel that lies inside a boundary at signed distance d_px (positive inside).

// Returns the coverage by a straight edge: xy is the unit vector towards the inside, z the distance of the pixel's centre.
// The area is exact: a triangle until the edge has passed a corner of the pixel, then a trapezium.
float covered(vec3 edge) {
  vec2 n = abs(edge.xy);
  float a = max(n.x, n.y), b = max(min(n.x, n.y), 1e-4);
  float d = edge.z * sharpness;
  float beyond = max(0.5 * (a + b) - abs(d), 0.0);  // distance that the edge still has to go to leave the pixel
  float smaller = beyond < b ? beyond * beyond / (2.0 * a * b) : (beyond - 0.5 * b) / a;
  return d > 0.0 ? 1.0 - smaller : smaller;
}

// Returns the coverage by a strip between two parallel edges, even one thinner than a pixel.
float coveredStrip(vec3 a, vec3 b) { return max(covered(a) + covered(b) - 1.0, 0.0); }

// Returns the coverage by a line, given its unit normal and the distance of its middle.
float coveredLine(float distance_px, vec2 normal, float width_px) {
  return coveredStrip(vec3(-normal, 0.5 * width_px - distance_px), vec3(normal, 0.5 * width_px + distance_px));
}

// Returns the coverage by a thin line of low contrast, as a ramp one pixel wide, which has the second moment of the pixel
// in every direction. Exact where the line is level or upright, at a fifth of the cost.
float faintLine(float distance_px, float width_px) {
  float width = width_px * sharpness;
  return clamp(0.5 * width + 0.5 - distance_px * sharpness, 0.0, min(width, 1.0));
}

// Returns the share of the pixel on the near side of the line where two surfaces cut each other. `ahead` is how much
// farther the other surface is; `slope` is the growth of `ahead` per pixel.
float shareBefore(float ahead, vec2 slope) {
  slope.x += 1e-9;  // gives a direction if the surfaces are parallel
  return covered(vec3(slope, ahead) / length(slope));
}

// Returns shareBefore() for glass and a solid, with the accuracy of faintLine().
float glassBefore(float ahead, vec2 slope) {
  return clamp(0.5 + sharpness * ahead * inversesqrt(dot(slope, slope) + 1e-18), 0.0, 1.0);
}

// Ellipse in the picture: centre and inverse covariance (xx, xy, yy), with rho = 1 on its edge. rho grows linearly from
// the centre, so that the first-order distance is exact for a circle.
struct ScreenEllipse {
  vec2 centre_px;
  vec3 form;
};

// Returns half the width of an ellipse where it is narrowest.
float halfWidth(ScreenEllipse e) {
  float difference = 0.5 * (e.form.x - e.form.z);
  return inversesqrt(0.5 * (e.form.x + e.form.z) + length(vec2(difference, e.form.y)));
}

// Returns the straight edge that approximates an ellipse at a pixel. No point inside is farther from the edge than half
// the width.
vec3 edgeAt(ScreenEllipse e, vec2 p_px) {
  vec2 q = p_px - e.centre_px;
  vec2 g = vec2(e.form.x * q.x + e.form.y * q.y, e.form.y * q.x + e.form.z * q.y);
  float rho = sqrt(max(dot(q, g), 1e-12)), slope = max(length(g), 1e-12);
  return vec3(-g / slope, min((1.0 - rho) * rho / slope, halfWidth(e)));
}

float covered(ScreenEllipse e, vec2 p_px) {
  vec3 edge = edgeAt(e, p_px);
  return coveredStrip(edge, vec3(-edge.xy, 2.0 * halfWidth(e) - edge.z));
}

// Returns a line (a, b, c), a x + b y + c, as an edge at a pixel; (a, b) is a unit vector towards the inside.
vec3 edgeAt(vec3 line, vec2 p_px) { return vec3(line.xy, dot(line.xy, p_px) + line.z); }

// innerOf() returns the edge that is farther in, outerOf() the edge that is farther out.
vec3 innerOf(vec3 a, vec3 b) { return a.z > b.z ? a : b; }
vec3 outerOf(vec3 a, vec3 b) { return a.z > b.z ? b : a; }

// Returns the coverage by a convex quadrilateral with opposite edges 0, 2 and 1, 3.
float coveredQuad(vec3 e0, vec3 e1, vec3 e2, vec3 e3, vec2 p_px) {
  return coveredStrip(edgeAt(e0, p_px), edgeAt(e2, p_px)) * coveredStrip(edgeAt(e1, p_px), edgeAt(e3, p_px));
}

// Integral of the width to the right of x within a pixel 1 wide.
float roomRightOf(float x) { return x < 0.0 ? x : (x < 1.0 ? x - 0.5 * x * x : 0.5); }

// Returns the area of the pixel to the right of a side of a polygon, negative for sides that go up. The sum over all sides
// is the exact area of the polygon, even if it is thin.
float areaRightOf(vec2 from_px, vec2 to_px, vec2 p_px) {
  vec2 a = (from_px - p_px) * sharpness + 0.5, b = (to_px - p_px) * sharpness + 0.5;
  float ya = clamp(a.y, 0.0, 1.0), yb = clamp(b.y, 0.0, 1.0), slope = (b.x - a.x) / (a.y == b.y ? 1.0 : b.y - a.y);
  float xa = a.x + (ya - a.y) * slope, xb = a.x + (yb - a.y) * slope, width = xb - xa;
  float room = abs(width) > 1e-3 ? (roomRightOf(xb) - roomRightOf(xa)) / width : clamp(1.0 - 0.5 * (xa + xb), 0.0, 1.0);
  return (yb - ya) * room;
}
