// SPDX-License-Identifier: Apache-2.0
// Analytic coverage: how much of a pixel lies inside a boundary at signed distance d_px (positive inside).
// 1 for pictures; large for the reference renderer, whose many samples see hard edges.
uniform float sharpness;

float covered(float d_px) { return clamp(0.5 + d_px * sharpness, 0.0, 1.0); }

// A strip between two parallel edges, right also where it is thinner than a pixel.
float coveredStrip(float a_px, float b_px) { return max(covered(a_px) + covered(b_px) - 1.0, 0.0); }

// An ellipse in the picture: centre and inverse covariance (xx, xy, yy), rho = 1 on its edge. rho grows
// linearly from the centre, so that the first-order distance is exact for a circle.
struct ScreenEllipse {
  vec2 centre_px;
  vec3 form;
};

float insideDistance(ScreenEllipse e, vec2 p_px) {
  vec2 q = p_px - e.centre_px;
  vec2 g = vec2(e.form.x * q.x + e.form.y * q.y, e.form.y * q.x + e.form.z * q.y);
  float rho = sqrt(max(dot(q, g), 1e-12));
  return (1.0 - rho) * rho / max(length(g), 1e-12);
}

// Signed distance to a line (a, b, c): a x + b y + c, (a, b) a unit vector towards the inside.
float insideDistance(vec3 line, vec2 p_px) { return dot(line.xy, p_px) + line.z; }

// A convex quadrilateral whose opposite edges are 0, 2 and 1, 3.
float coveredQuad(vec3 e0, vec3 e1, vec3 e2, vec3 e3, vec2 p_px) {
  return coveredStrip(insideDistance(e0, p_px), insideDistance(e2, p_px)) *
         coveredStrip(insideDistance(e1, p_px), insideDistance(e3, p_px));
}
