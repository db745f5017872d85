// SPDX-License-Identifier: Apache-2.0
#include "camera.glsl"
#include "coverage.glsl"
#include "graticule.glsl"

// Puts one pixel together from everything that was kept of it: the nearest solid that fills it, the two nearest
// edges, and every translucent sheet, which is solved for here. Each fragment is dimmed by those in front of it;
// no order of drawing exists, so none can be wrong. Linear light until the last line.
#if SOLIDS
uniform sampler2D solidColor, solidDepth;
uniform sampler2D edgeColor, edgeDepth, nextEdgeColor, nextEdgeDepth;
const int kEdges = 2;
#else
const int kEdges = 0;
#endif
uniform vec3 background;

#if ELLIPSOIDS > 0
uniform vec3 centre_C[ELLIPSOIDS];
uniform mat3 toUnitSphere[ELLIPSOIDS];
uniform vec2 outlineCentre_px[ELLIPSOIDS];
uniform vec3 outlineForm[ELLIPSOIDS];
uniform vec4 glassColor[ELLIPSOIDS];       // rgb, opacity of the far sheet flat-on
uniform vec4 graticuleColor[ELLIPSOIDS];   // rgb, opacity (0: none)
uniform vec4 glassOptions[ELLIPSOIDS];     // rim opacity, graticule width in px, its factor on the far sheet, opacity of the near sheet flat-on
#endif
#if PLANES > 0
uniform vec3 planeCentre_C[PLANES];
uniform vec3 planeNormal_C[PLANES];
uniform vec3 planeU_C[PLANES];             // unit
uniform vec3 planeV_C[PLANES];
uniform vec3 planeEdges[4 * PLANES];
uniform vec4 planeColor[PLANES];           // rgb, opacity
uniform vec4 gridColor[PLANES];            // rgb, opacity
uniform vec4 planeOptions[PLANES];         // half extents u and v, spacing, line width in px
uniform vec4 shadow[PLANES];               // centre in the plane (u, v), radius, opacity
#endif
#if CONES > 0
uniform vec3 coneApex_C[CONES];
uniform vec3 coneAxis_C[CONES];            // unit, from the apex to the base
uniform vec4 coneShape[CONES];             // centre of the base in px, height, radius / height
uniform vec3 baseForm[CONES];
uniform vec3 coneSides[3 * CONES];         // a silhouette, the line between the tangent points, the other silhouette
uniform vec4 coneColor[CONES];             // rgb, opacity of the inside flat-on
uniform vec4 coneLine[CONES];              // around the base: rgb, opacity
uniform vec4 coneOptions[CONES];           // rim opacity, opacity of the outside flat-on, line width in px, 1 when the eye looks in at the base
#endif
#if POLYGONS > 0
uniform vec3 polygonPoint_C[POLYGONS];
uniform vec3 polygonNormal_C[POLYGONS];
uniform vec3 polygonEdges[SIDES * POLYGONS];
uniform vec2 polygonCorners_px[SIDES * POLYGONS];
uniform vec4 polygonColor[POLYGONS];       // rgb, opacity
uniform vec4 polygonLine[POLYGONS];        // rgb, opacity
uniform vec4 polygonOptions[POLYGONS];     // line width in px, distance of the nearest corner and of the farthest
#endif

out vec4 pixel;

const int kPlanes = kEdges + 2 * ELLIPSOIDS, kCones = kPlanes + PLANES, kPolygons = kCones + 3 * CONES;
const int kFragments = kPolygons + POLYGONS;
vec4 colors[kFragments];   // straight rgb, opacity
float depths[kFragments];

// `over` laid on `under`, both straight.
vec4 layOver(vec4 over, vec4 under) {
  float a = over.a + under.a * (1.0 - over.a);
  return vec4((over.rgb * over.a + under.rgb * under.a * (1.0 - over.a)) / max(a, 1e-6), a);
}

// The coverage to give the far wall of a body, so that behind the near one (of that opacity) it has its own. The two
// end at one outline: were they taken for independent, the outline would come out too dark.
float behindNear(float farCover, float nearCover, float nearOpacity) {
  return (farCover - min(farCover, nearCover) * nearOpacity) / max(1.0 - nearCover * nearOpacity, 1e-6);
}

#if ELLIPSOIDS > 0
void addEllipsoid(int k, int slot, vec2 p_px, vec3 ray) {
  float coverage = covered(edgeAt(ScreenEllipse(outlineCentre_px[k], outlineForm[k]), p_px));
  vec3 toCentre_C = centre_C[k] - rayFrom(p_px);
  float t0 = dot(toCentre_C, ray) / dot(ray, ray);
  vec3 o = toUnitSphere[k] * (t0 * ray - toCentre_C), d = toUnitSphere[k] * ray;
  float a = dot(d, d), along = dot(o, d) / a;
  vec3 offset = o - along * d;
  float halfChord = sqrt(max(1.0 - dot(offset, offset), 0.0) / a);
  vec3 towardEye_C = -normalize(ray);
  float nearOpacity = 0.0;
  for (int sheet = 0; sheet < 2; ++sheet) {
    float t = -along + (sheet == 0 ? -halfChord : halfChord);
    vec3 s = o + t * d;
    vec3 n_C = normalize(s * toUnitSphere[k]);
    float grazing = 1.0 - abs(dot(n_C, towardEye_C));
    // Flat-on the near sheet is the thinner one, so that what is inside keeps its hue; at the rim the two meet.
    float flatOn = sheet == 0 ? glassOptions[k].w : glassColor[k].a;
    vec4 color = vec4(glassColor[k].rgb, mix(flatOn, glassOptions[k].x, grazing * grazing * grazing));
    float size = pixelSize(t0 + t);
    vec3 dx = changeOnSphere(s, d, size * toUnitSphere[k][0]), dy = changeOnSphere(s, d, -size * toUnitSphere[k][1]);
    float lines = graticuleColor[k].a > 0.0 ? graticule(s, dx, dy, glassOptions[k].y) : 0.0;
    lines *= graticuleColor[k].a * (sheet == 0 ? 1.0 : glassOptions[k].z);
    color = layOver(vec4(graticuleColor[k].rgb, lines), color);
    colors[slot + sheet] = vec4(color.rgb, color.a * behindNear(coverage, coverage, nearOpacity));
    depths[slot + sheet] = toDepth(t0 + t);
    nearOpacity = color.a;
  }
}
#endif

#if PLANES > 0
// One family of grid lines at coordinate c (in spacings); fades where lines come closer than a few pixels.
float gridLines(float c, float width_px) {
  vec2 slope = vec2(dFdx(c), dFdy(c));
  float spacing_px = 1.0 / max(length(slope), 1e-9);
  float fade = clamp((spacing_px - 2.0 * width_px) / (4.0 * width_px), 0.0, 1.0);
  return lineCover(c - round(c), slope, width_px) * fade;
}

void addPlane(int k, int slot, vec2 p_px, vec3 ray) {
  float along = dot(planeNormal_C[k], ray);
  vec3 toCentre_C = planeCentre_C[k] - rayFrom(p_px);
  float t = dot(planeNormal_C[k], toCentre_C) / (abs(along) > 1e-7 ? along : 1e-7);
  vec3 x = t * ray - toCentre_C;
  vec2 uv = vec2(dot(planeU_C[k], x), dot(planeV_C[k], x));
  vec4 options = planeOptions[k];
  float coverage = coveredQuad(planeEdges[4 * k], planeEdges[4 * k + 1], planeEdges[4 * k + 2],
                               planeEdges[4 * k + 3], p_px);
  vec4 color = planeColor[k];
  vec2 fromShadow = (uv - shadow[k].xy) / max(shadow[k].z, 1e-6);
  float dark = shadow[k].w * exp2(-2.0 * dot(fromShadow, fromShadow));
  color = layOver(vec4(vec3(0.02), dark), color);
  // The border is a line just inside the edge of the sheet.
  vec3 edge = outerOf(outerOf(edgeAt(planeEdges[4 * k], p_px), edgeAt(planeEdges[4 * k + 1], p_px)),
                      outerOf(edgeAt(planeEdges[4 * k + 2], p_px), edgeAt(planeEdges[4 * k + 3], p_px)));
  float lines = max(gridLines(uv.x / options.z, options.w), gridLines(uv.y / options.z, options.w));
  lines = max(lines, covered(vec3(-edge.xy, 1.5 * options.w - edge.z)));
  color = layOver(vec4(gridColor[k].rgb, gridColor[k].a * lines), color);
  colors[slot] = vec4(color.rgb, t > 0.0 ? color.a * coverage : 0.0);
  depths[slot] = toDepth(t);
}
#endif

#if CONES > 0
// Glass is denser where it is seen edge-on.
float coneOpacity(float flatOn, float rim, vec3 x_C, float height, vec3 axis_C, float slope, vec3 towardEye_C) {
  vec3 radial = normalize(x_C - height * axis_C + 1e-12 * towardEye_C);
  float grazing = 1.0 - min(abs(dot(radial - slope * axis_C, towardEye_C)) * inversesqrt(1.0 + slope * slope), 1.0);
  return mix(flatOn, rim, grazing * grazing * grazing);
}

// Three fragments: the side whose outside looks at the eye, the one whose inside does, and the line around the base.
// Closed by its base the cone is convex: what is seen through its outline crosses the one side and the other, but for
// one of them the base where that is seen.
void addCone(int k, int slot, vec2 p_px, vec3 ray) {
  vec3 axis = coneAxis_C[k], towardEye_C = -normalize(ray);
  float height = coneShape[k].z, slope = coneShape[k].w, radius = slope * height;
  vec4 options = coneOptions[k];
  vec3 base = edgeAt(ScreenEllipse(coneShape[k].xy, baseForm[k]), p_px);
  float inBase = covered(base);
  float between = coveredStrip(edgeAt(coneSides[3 * k], p_px), edgeAt(coneSides[3 * k + 2], p_px)) *
                  covered(edgeAt(coneSides[3 * k + 1], p_px));
  float whole = max(inBase, between);

  vec3 toApex_C = coneApex_C[k] - rayFrom(p_px);
  float t0 = dot(toApex_C, ray) / dot(ray, ray);
  vec3 o = t0 * ray - toApex_C;  // from the apex to the nearest point of the ray
  float du = dot(ray, axis), ou = dot(o, axis), kk = 1.0 + slope * slope;
  float a = dot(ray, ray) - kk * du * du, b = dot(ray, o) - kk * du * ou, c = dot(o, o) - kk * ou * ou;
  float root = sqrt(max(b * b - a * c, 0.0));
  // Without cancellation; a changes sign when the ray runs into the cone.
  float q = b > 0.0 ? -b - root : -b + root;
  float r1 = q / (abs(a) > 1e-9 ? a : 1e-9), r2 = abs(q) > 1e-20 ? c / q : r1;
  float first = min(r1, r2), last = max(r1, r2);
  // Of the two, one may lie beyond the base or on the cone's other half.
  float firstHeight = ou + first * du, lastHeight = ou + last * du, slack = 0.02 * height;
  float tOutside = firstHeight > -1e-4 * height && firstHeight < height + slack ? first : last;
  float tInside = lastHeight > -1e-4 * height && lastHeight < height + slack ? last : first;
  float size = 2.0 * (height + radius);
  float tAxis = dot(clamp(ou, 0.0, height) * axis - o, ray) / dot(ray, ray);
  float nearCover = 0.0, nearOpacity = 0.0;
  for (int sheet = 0; sheet < 2; ++sheet) {
    float t = clamp(sheet == 0 ? tOutside : tInside, tAxis - size, tAxis + size);
    float flatOn = sheet == 0 ? options.y : coneColor[k].a;
    float opacity = coneOpacity(flatOn, options.x, o + t * ray, ou + t * du, axis, slope, towardEye_C);
    float open = sheet == 0 ? options.w : 1.0 - options.w;  // where the base is seen, this side is not
    float cover = max(whole - open * inBase, 0.0);
    colors[slot + sheet] = vec4(coneColor[k].rgb, opacity * behindNear(cover, nearCover, nearOpacity));
    depths[slot + sheet] = toDepth(t0 + t);
    nearCover = cover;
    nearOpacity = opacity;
  }
  float halfWidth = 0.5 * options.z;
  float line = coveredStrip(vec3(-base.xy, halfWidth - base.z), vec3(base.xy, halfWidth + base.z));
  float tBase = t0 + clamp((height - ou) / (abs(du) > 1e-7 ? du : 1e-7), tAxis - size, tAxis + size);
  colors[slot + 2] = vec4(coneLine[k].rgb, coneLine[k].a * line);
  depths[slot + 2] = toDepth(tBase - options.z * pixelSize(tBase));  // before the sheet that it borders
}
#endif

#if POLYGONS > 0
void addPolygon(int k, int slot, vec2 p_px, vec3 ray) {
  vec3 nearest = edgeAt(polygonEdges[SIDES * k], p_px);
  float cover = 0.0;
  for (int i = 0; i < SIDES; ++i) {
    nearest = outerOf(nearest, edgeAt(polygonEdges[SIDES * k + i], p_px));
    cover += areaRightOf(polygonCorners_px[SIDES * k + i], polygonCorners_px[SIDES * k + (i + 1) % SIDES], p_px);
  }
  float along = dot(polygonNormal_C[k], ray);
  float t = dot(polygonNormal_C[k], polygonPoint_C[k] - rayFrom(p_px)) / (abs(along) > 1e-7 ? along : 1e-7);
  float border = covered(vec3(-nearest.xy, polygonOptions[k].x - nearest.z));
  vec4 color = layOver(vec4(polygonLine[k].rgb, polygonLine[k].a * border), polygonColor[k]);
  colors[slot] = vec4(color.rgb, color.a * min(abs(cover), 1.0));
  depths[slot] = toDepth(clamp(t, polygonOptions[k].y, polygonOptions[k].z));
}
#endif

vec3 toSrgb(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308))));
}

#if SOLIDS
// How the solids' depth grows to the right and down, from the flatter side: not across an outline.
vec2 solidSlope(ivec2 texel, float depth) {
  float left = depth - texelFetch(solidDepth, texel - ivec2(1, 0), 0).r;
  float right = texelFetch(solidDepth, texel + ivec2(1, 0), 0).r - depth;
  float above = depth - texelFetch(solidDepth, texel - ivec2(0, 1), 0).r;
  float below = texelFetch(solidDepth, texel + ivec2(0, 1), 0).r - depth;
  return vec2(abs(left) < abs(right) ? left : right, abs(above) < abs(below) ? above : below);
}

#endif

void main() {
  vec2 p_px = gl_FragCoord.xy;
  ivec2 texel = ivec2(p_px);
  vec3 ray = rayThrough(p_px);
#if SOLIDS
  colors[0] = texelFetch(edgeColor, texel, 0);
  depths[0] = texelFetch(edgeDepth, texel, 0).r;
  colors[1] = texelFetch(nextEdgeColor, texel, 0);
  depths[1] = texelFetch(nextEdgeDepth, texel, 0).r;
  vec4 solid = texelFetch(solidColor, texel, 0);
  solid.a = float(solid.a > 0.0);  // it holds the solid's number
  float depth = texelFetch(solidDepth, texel, 0).r;
#else
  vec4 solid = vec4(0.0);
  float depth = 1.0;
#endif
#if ELLIPSOIDS > 0
  for (int k = 0; k < ELLIPSOIDS; ++k) addEllipsoid(k, kEdges + 2 * k, p_px, ray);
#endif
#if PLANES > 0
  for (int k = 0; k < PLANES; ++k) addPlane(k, kPlanes + k, p_px, ray);
#endif
#if CONES > 0
  for (int k = 0; k < CONES; ++k) addCone(k, kCones + 3 * k, p_px, ray);
#endif
#if POLYGONS > 0
  for (int k = 0; k < POLYGONS; ++k) addPolygon(k, kPolygons + k, p_px, ray);
#endif

  for (int i = 0; i < kEdges; ++i) colors[i].a *= float(depths[i] <= depth);
#if SOLIDS
  vec2 slope = solidSlope(texel, depth);
  for (int i = kEdges; i < kFragments; ++i)
    colors[i].a *= shareBefore(depth - depths[i], slope - vec2(dFdx(depths[i]), dFdy(depths[i])));
#endif

  vec3 sum = vec3(0.0);
  float left = 1.0;  // what of the light behind everything comes through
  for (int i = 0; i < kFragments; ++i) {
    float through = colors[i].a;
    for (int j = 0; j < kFragments; ++j)
      if (j != i) through *= 1.0 - colors[j].a * float(depths[j] < depths[i] || (depths[j] == depths[i] && j < i));
    sum += through * colors[i].rgb;
    left *= 1.0 - colors[i].a;
  }
#if TRANSPARENT
  float alpha = 1.0 - left * (1.0 - solid.a);
  sum += left * solid.a * solid.rgb;
  pixel = vec4(toSrgb(sum / max(alpha, 1e-6)), alpha);
#else
  sum += left * mix(background, solid.rgb, solid.a);
  pixel = vec4(toSrgb(sum), 1.0);
#endif
}
