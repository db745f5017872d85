// SPDX-License-Identifier: Apache-2.0
struct Glass {
  vec3 color;
  float rimOpacity;
  vec4 lineColor;      // a: opacity, 0 if there is no graticule
  vec2 lineWidth_px;   // width and its reciprocal
};

// Returns the sheet at one end of a chord: premultiplied colour with its opacity.
vec4 sheetColor(Glass glass, RayEllipsoid e, Chord chord, ChordEnd end, float t, float opacity, float lineShare) {
  float grazing = 1.0 - end.facing;  // glass is denser where it is seen along the surface
  float lines = glass.lineColor.a > 0.0 ? graticule(spherePoint(e, chord, end, pixelSize(t)), glass.lineWidth_px) : 0.0;
  return layOver(premultiplied(glass.lineColor.rgb, glass.lineColor.a * lineShare * lines),
                 premultiplied(glass.color, mix(opacity, glass.rimOpacity, grazing * grazing * grazing)));
}

// Adds the near and the far sheet of an ellipsoid. Flat-on, the near sheet is the thinner one, so that what is inside
// keeps its hue; the two meet at the rim.
void addEllipsoid(int i, int slot, vec2 p_px, vec3 ray) {
  RayEllipsoid e = rayEllipsoid(i);
  Glass glass = Glass(own(i + 9).rgb, own(i + 6).w, own(i + 10), own(i + 11).yz);
  float nearOpacity = own(i + 7).w, farOpacity = own(i + 8).w, farLines = own(i + 11).x;

  Chord chord = chordOf(e, p_px);
  float ray2 = dot(ray, ray);
  ChordEnd near = endOf(e, chord, -1.0, ray2), far = endOf(e, chord, 1.0, ray2);
  float tNear = e.distance + near.t, tFar = e.distance + far.t;
  vec4 nearColor = sheetColor(glass, e, chord, near, tNear, nearOpacity, 1.0);
  vec4 farColor = sheetColor(glass, e, chord, far, tFar, farOpacity, farLines);
#if OUTLINES
  float coverage = covered(edgeAt(e.outline, p_px));
  farColor *= behindNear(coverage, coverage, nearColor.a);
  nearColor *= coverage;
#endif
  colors[slot] = nearColor;
  depths[slot] = toDepth(tNear);
  colors[slot + 1] = farColor;
  depths[slot + 1] = toDepth(tFar);
}
