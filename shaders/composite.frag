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

out vec4 pixel;

const int kFragments = kEdges + 2 * ELLIPSOIDS + PLANES;
vec4 colors[kFragments];   // straight rgb, opacity
float depths[kFragments];

// `over` laid on `under`, both straight.
vec4 layOver(vec4 over, vec4 under) {
  float a = over.a + under.a * (1.0 - over.a);
  return vec4((over.rgb * over.a + under.rgb * under.a * (1.0 - over.a)) / max(a, 1e-6), a);
}

#if ELLIPSOIDS > 0
void addEllipsoid(int k, int slot, vec2 p_px, vec3 ray) {
  float coverage = covered(edgeAt(ScreenEllipse(outlineCentre_px[k], outlineForm[k]), p_px));
  float t0 = dot(centre_C[k], ray) / dot(ray, ray);
  vec3 o = toUnitSphere[k] * (t0 * ray - centre_C[k]), d = toUnitSphere[k] * ray;
  float a = dot(d, d), along = dot(o, d) / a;
  vec3 offset = o - along * d;
  float halfChord = sqrt(max(1.0 - dot(offset, offset), 0.0) / a);
  vec3 towardEye_C = -normalize(ray);
  for (int sheet = 0; sheet < 2; ++sheet) {
    float t = -along + (sheet == 0 ? -halfChord : halfChord);
    vec3 s = o + t * d;
    vec3 n_C = normalize(s * toUnitSphere[k]);
    float grazing = 1.0 - abs(dot(n_C, towardEye_C));
    // Flat-on the near sheet is the thinner one, so that what is inside keeps its hue; at the rim the two meet.
    float flatOn = sheet == 0 ? glassOptions[k].w : glassColor[k].a;
    vec4 color = vec4(glassColor[k].rgb, mix(flatOn, glassOptions[k].x, grazing * grazing * grazing));
    float lines = graticuleColor[k].a > 0.0 ? graticule(s, glassOptions[k].y) : 0.0;
    lines *= graticuleColor[k].a * (sheet == 0 ? 1.0 : glassOptions[k].z);
    color = layOver(vec4(graticuleColor[k].rgb, lines), color);
    colors[slot + sheet] = vec4(color.rgb, color.a * coverage);
    depths[slot + sheet] = toDepth(t0 + t);
  }
}
#endif

#if PLANES > 0
// One family of grid lines at coordinate c (in spacings); fades where lines come closer than a few pixels.
float gridLines(float c, float width_px) {
  float slope = max(length(vec2(dFdx(c), dFdy(c))), 1e-9);
  float spacing_px = 1.0 / slope;
  float fade = clamp((spacing_px - 2.0 * width_px) / (4.0 * width_px), 0.0, 1.0);
  return lineCover((c - round(c)) * spacing_px, width_px) * fade;
}

void addPlane(int k, int slot, vec2 p_px, vec3 ray) {
  float along = dot(planeNormal_C[k], ray);
  float t = dot(planeNormal_C[k], planeCentre_C[k]) / (abs(along) > 1e-7 ? along : 1e-7);
  vec3 x = t * ray - planeCentre_C[k];
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

vec3 toSrgb(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308))));
}

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
  float depth = texelFetch(solidDepth, texel, 0).r;
#else
  vec4 solid = vec4(0.0);
  float depth = 1.0;
#endif
#if ELLIPSOIDS > 0
  for (int k = 0; k < ELLIPSOIDS; ++k) addEllipsoid(k, kEdges + 2 * k, p_px, ray);
#endif
#if PLANES > 0
  for (int k = 0; k < PLANES; ++k) addPlane(k, kEdges + 2 * ELLIPSOIDS + k, p_px, ray);
#endif

  for (int i = 0; i < kFragments; ++i) colors[i].a *= float(depths[i] <= depth);

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
