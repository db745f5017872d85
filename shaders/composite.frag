// SPDX-License-Identifier: Apache-2.0
// Composes one pixel from everything kept for it: the nearest solid that fills it, the two nearest edges, and all
// translucent sheets, which are solved for here. Each fragment is dimmed by those in front of it, so that no drawing order
// exists that could be wrong. Light is linear until the last line.
//
// The shader is compiled for one kind of place. SOLIDS is 0 where no solid is, 1 inside a solid, 2 where one edge may be
// in a pixel, and 3 where two may. OUTLINES is 0 where every sheet that is drawn fills the place.
#if SOLIDS > 0
uniform sampler2DRect solidColor, solidDepth;
#endif
#if SOLIDS > 1
uniform sampler2DRect edgeColor, edgeDepth;
#endif
#if SOLIDS > 2
uniform sampler2DRect nextEdgeColor, nextEdgeDepth;
#endif
const int kEdges = SOLIDS > 1 ? SOLIDS - 1 : 0;

#include "constants.glsl"
#include "camera.glsl"
#include "coverage.glsl"
#include "graticule.glsl"
#include "ray_ellipsoid.glsl"
#include "sheet.glsl"
#if SOLIDS > 1
#include "kept_edge.glsl"
#endif

// Premultiplied colours and depths of all fragments in one pixel. There are no loops over them, because llvmpipe reads and
// writes arrays lane by lane unless it unrolls the loop. The macro EACH_...(f), made for the place, calls f for each
// number; EACH_PAIR calls it for each pair, the smaller number first.
const int kFirstPlane = kEdges + 2 * ELLIPSOIDS, kFirstCone = kFirstPlane + PLANES;
const int kFirstPolygon = kFirstCone + 3 * CONES, kFragments = kFirstPolygon + POLYGONS;
vec4 colors[kFragments + 1];
float depths[kFragments + 1];

#if ELLIPSOIDS > 0
#include "sheet_ellipsoid.glsl"
#endif
#if PLANES > 0
#include "sheet_plane.glsl"
#endif
#if CONES > 0
#include "sheet_cone.glsl"
#endif
#if POLYGONS > 0
#include "sheet_polygon.glsl"
#endif

// Indices of the first constants of each kind of sheet. A sheet takes OF_... constants; constant 0 is the paper's colour.
const int kEllipsoids = 1, kPlanes = kEllipsoids + OF_ELLIPSOID * ELLIPSOIDS;
const int kCones = kPlanes + OF_PLANE * PLANES, kPolygons = kCones + OF_CONE * CONES;

out vec4 pixel;

#include "srgb.glsl"

#if SOLIDS > 1
void addEdge(int slot, sampler2DRect edgeColors, sampler2DRect edgeDepths, ivec2 texel, float depth) {
  vec4 kept = texelFetch(edgeColors, texel);
  depths[slot] = texelFetch(edgeDepths, texel).r;
  colors[slot] = premultiplied(kept.rgb, coverageOf(kept.a)) * float(depths[slot] <= depth && depths[slot] < 1.0);
}

#if SOLIDS > 2
// Largest distance, in pixel sizes, of a line in front of what it marks. At 8 some lines are missed; at 60 no more are
// found.
const float kLift_px = 20.0;

// Returns the share of a pixel that neither a line nor the edge behind it covers, if one lies along the other. Of two
// lines, such as laps of a path, the one with more coverage hides the other. A line on an outline has its middle there,
// and half of it is outside; this is exact where the outline is level or upright.
float openBeside(float line, float other, bool otherIsLine) {
  return otherIsLine ? 1.0 - max(line, other) : clamp(1.0 - other - 0.5 * line, 0.0, 1.0 - line);
}

// Adjusts the second edge to a line in front of it. Edges that cross hide each other as chance would have it, and dimming
// the second one is enough. But a line usually marks what is right behind it. Then the second edge gets the opacity that
// leaves open the share of openBeside().
void fitToLine(ivec2 texel) {
  float line = colors[0].a, other = colors[1].a;
  float lift = kLift_px * pixelSize(depthRange.x + depths[0] / depthRange.y) * depthRange.y;
  if (!isLine(texelFetch(edgeColor, texel).a) || line * other == 0.0 || depths[1] - depths[0] > lift) return;
  float open = openBeside(line, other, isLine(texelFetch(nextEdgeColor, texel).a));
  colors[1] *= (1.0 - open / (1.0 - line)) / other;
}
#endif

// Returns how the solids' depth grows to the right and down. Takes the flatter side, so as not to cross an outline.
vec2 solidSlope(ivec2 texel, float depth) {
  float left = depth - texelFetch(solidDepth, texel - ivec2(1, 0)).r;
  float right = texelFetch(solidDepth, texel + ivec2(1, 0)).r - depth;
  float above = depth - texelFetch(solidDepth, texel - ivec2(0, 1)).r;
  float below = texelFetch(solidDepth, texel + ivec2(0, 1)).r - depth;
  return vec2(abs(left) < abs(right) ? left : right, abs(above) < abs(below) ? above : below);
}
#elif SOLIDS == 1
vec2 solidSlope(ivec2 texel, float depth) { return vec2(dFdx(depth), dFdy(depth)); }
#endif

void main() {
  vec2 p_px = gl_FragCoord.xy;
  vec3 ray = rayThrough(p_px);
#define ADD_ELLIPSOID(k) addEllipsoid(kEllipsoids + OF_ELLIPSOID * k, kEdges + 2 * k, p_px, ray);
#define ADD_PLANE(k) addPlane(kPlanes + OF_PLANE * k, kFirstPlane + k, p_px);
#define ADD_CONE(k) addCone(kCones + OF_CONE * k, kFirstCone + 3 * k, p_px, ray);
#define ADD_POLYGON(k) addPolygon(kPolygons + OF_POLYGON * k, kFirstPolygon + k, p_px, ray);
  EACH_ELLIPSOID(ADD_ELLIPSOID)
  EACH_PLANE(ADD_PLANE)
  EACH_CONE(ADD_CONE)
  EACH_POLYGON(ADD_POLYGON)

  vec4 solid = vec4(0.0);
#if SOLIDS > 0
  ivec2 texel = ivec2(p_px - layers_px);
  float depth = texelFetch(solidDepth, texel).r;
  vec2 slope = solidSlope(texel, depth);
  solid = texelFetch(solidColor, texel);
  solid.a = float(depth < 1.0);  // otherwise the colour is stale
#define CUT(i) colors[i] *= glassBefore(depth - depths[i], slope - vec2(dFdx(depths[i]), dFdy(depths[i])));
  EACH_SHEET(CUT)
#endif
#if SOLIDS > 1
  addEdge(0, edgeColor, edgeDepth, texel, depth);
#endif
#if SOLIDS > 2
  addEdge(1, nextEdgeColor, nextEdgeDepth, texel, depth);
  fitToLine(texel);
#endif

  // `through` is the visible share of each fragment, and `left` that of what is behind all of them.
  float left = 1.0;
  vec3 sum = vec3(0.0);
  float through[kFragments + 1];
#define BEGIN(i) through[i] = 1.0; left *= 1.0 - colors[i].a;
#define DIM(i, j) { \
    float jFirst = float(depths[j] < depths[i]); \
    through[i] *= 1.0 - colors[j].a * jFirst; \
    through[j] *= 1.0 - colors[i].a * (1.0 - jFirst); \
  }
#define ADD(i) sum += through[i] * colors[i].rgb;
  EACH_FRAGMENT(BEGIN)
  EACH_PAIR(DIM)
  EACH_FRAGMENT(ADD)
#if TRANSPARENT
  float alpha = 1.0 - left * (1.0 - solid.a);
  sum += left * solid.a * solid.rgb;
  pixel = vec4(toSrgb(sum / max(alpha, 1e-6)), alpha);
#else
  sum += left * mix(own(0).rgb, solid.rgb, solid.a);
  pixel = vec4(toSrgb(sum), 1.0);
#endif
}
