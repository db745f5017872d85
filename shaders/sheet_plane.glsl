// SPDX-License-Identifier: Apache-2.0
// Returns the coverage by one family of grid lines at coordinate c (in spacings). It fades where lines are closer than a
// few pixels. The width comes with its reciprocal.
float gridLines(float c, vec2 width_px) {
  vec2 slope = vec2(dFdx(c), dFdy(c));
  float spacing_px = inversesqrt(dot(slope, slope) + 1e-18);
  float fade = clamp(0.25 * spacing_px * width_px.y - 0.5, 0.0, 1.0);
  return faintLine(abs(c - round(c)) * spacing_px, width_px.x) * fade;
}

// Share of the shadow below which there is none.
const float kShadowEnd = 1.0 / 512.0;

// Adds a rectangle with a grid, a border and a soft shadow. Its coordinates (in spacings) and its depth are quotients of
// functions that are linear over the picture.
void addPlane(int i, int slot, vec2 p_px) {
  vec3 q = vec3(p_px - vec2(own(i).w, own(i + 1).w), 1.0);
  float inverse = 1.0 / max(dot(own(i + 3).xyz, q), 1e-6);  // 1 at the centre; nothing shows beyond the horizon
  vec2 uv = vec2(dot(own(i).xyz, q), dot(own(i + 1).xyz, q)) * inverse;
  vec2 lineWidth_px = vec2(own(i + 2).w, own(i + 3).w);  // width and its reciprocal
  vec4 lineColor = own(i + 9);
  vec4 shadow = vec4(fourthsOf(i + 4), own(i + 7).w);  // centre, 1 / radius, opacity

  vec2 fromShadow = (uv - shadow.xy) * shadow.z;
  float dark = shadow.w * max(exp2(-2.0 * dot(fromShadow, fromShadow)) - kShadowEnd, 0.0);
  vec4 color = layOver(premultiplied(vec3(0.02), dark), premultiplied(own(i + 8)));
  float lines = max(gridLines(uv.x, lineWidth_px), gridLines(uv.y, lineWidth_px));
#if OUTLINES
  vec3 e0 = edgeAt(own(i + 4).xyz, p_px), e1 = edgeAt(own(i + 5).xyz, p_px);
  vec3 e2 = edgeAt(own(i + 6).xyz, p_px), e3 = edgeAt(own(i + 7).xyz, p_px);
  // The border is a line just inside the edge of the sheet.
  vec3 edge = outerOf(outerOf(e0, e1), outerOf(e2, e3));
  lines = max(lines, covered(vec3(-edge.xy, 1.5 * lineWidth_px.x - edge.z)));
#endif
  color = layOver(premultiplied(lineColor.rgb, lineColor.a * lines), color);
#if OUTLINES
  color *= coveredStrip(e0, e2) * coveredStrip(e1, e3);
#endif
  colors[slot] = color;
  depths[slot] = clamp(dot(own(i + 2).xyz, q) * inverse, 0.0, 1.0);
}
