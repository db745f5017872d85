// SPDX-License-Identifier: Apache-2.0
// Puts one pixel together from everything that was kept of it: the nearest solid that fills it, the two nearest
// edges, and every translucent sheet, which is solved for here. Each fragment is dimmed by those in front of it;
// no order of drawing exists, so none can be wrong. Linear light until the last line.
//
// Made for one kind of place: SOLIDS is 0 where no solid is, 1 inside one, 2 where one may end in a pixel and 3 where two
// may; OUTLINES is 0 where every sheet that is drawn fills the place.
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

// Of all that is in one pixel: premultiplied colour, depth. There is no loop over them: what llvmpipe does not unroll
// it reads and writes lane by lane. EACH_...(f), made for the place, calls f for each number; EACH_PAIR for two, the
// smaller one first.
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

// Where the constants of each kind begin, of which one takes OF_...; a vector of the paper's colour is before them.
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
// How far before what it marks a line may be, in pixels' size. At 8 some are missed, at 60 no more are found.
const float kLift_px = 20.0;

// How much of a pixel neither a line nor the edge behind it covers, where one lies along the other. Of two lines, as laps
// of a path, the one that covers more hides the other. A line on an outline has its middle there, and half of it lies
// outside: exact where the outline is level or upright.
float openBeside(float line, float other, bool otherIsLine) {
  return otherIsLine ? 1.0 - max(line, other) : clamp(1.0 - other - 0.5 * line, 0.0, 1.0 - line);
}

// Edges that cross hide of one another what chance would have it, and the second needs no more than to be dimmed. A
// line mostly marks what is right behind it: then the second edge gets the opacity that leaves open what is.
void fitToLine(ivec2 texel) {
  float line = colors[0].a, other = colors[1].a;
  float lift = kLift_px * pixelSize(depthRange.x + depths[0] / depthRange.y) * depthRange.y;
  if (!isLine(texelFetch(edgeColor, texel).a) || line * other == 0.0 || depths[1] - depths[0] > lift) return;
  float open = openBeside(line, other, isLine(texelFetch(nextEdgeColor, texel).a));
  colors[1] *= (1.0 - open / (1.0 - line)) / other;
}
#endif

// How the solids' depth grows to the right and down, from the flatter side: not across an outline.
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
  solid.a = float(depth < 1.0);  // else the colour is of a picture before
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

  // What comes through of each, and of what is behind all.
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
