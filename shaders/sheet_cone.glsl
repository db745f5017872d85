// SPDX-License-Identifier: Apache-2.0
// Returns the opacity of a cone's glass, which is denser where it is seen edge-on.
float coneOpacity(float flatOn, float rim, vec3 x_C, float height, vec3 axis_C, float slope, vec3 towardEye_C) {
  vec3 radial = normalize(x_C - height * axis_C + 1e-12 * towardEye_C);
  float grazing = 1.0 - min(abs(dot(radial - slope * axis_C, towardEye_C)) * inversesqrt(1.0 + slope * slope), 1.0);
  return mix(flatOn, rim, grazing * grazing * grazing);
}

// Adds three fragments: the side whose outside faces the eye, the side whose inside does, and the line around the base.
// Closed by its base, the cone is convex. So a ray through its outline crosses both sides, except where it crosses the
// visible base instead of one of them.
void addCone(int i, int slot, vec2 p_px, vec3 ray) {
  vec3 apex_C = own(i).xyz, axis = own(i + 1).xyz;  // unit, from the apex to the base
  float height = own(i + 2).w, slope = own(i + 3).w, radius = slope * height;
  float rimOpacity = own(i + 4).w, outsideOpacity = own(i + 5).w;
  vec4 insideColor = own(i + 6), lineColor = own(i + 7);  // alpha: opacity flat-on
  float lineWidth_px = own(i + 8).x, looksIn = own(i + 8).y;  // 1 if the eye looks in at the base
  vec3 towardEye_C = -normalize(ray);
  vec3 base = edgeAt(ScreenEllipse(vec2(own(i).w, own(i + 1).w), own(i + 2).xyz), p_px);
  float inBase = covered(base);
  // The silhouettes, and the line between the points where they touch the base.
  float between = coveredStrip(edgeAt(own(i + 3).xyz, p_px), edgeAt(own(i + 5).xyz, p_px)) *
                  covered(edgeAt(own(i + 4).xyz, p_px));
  float whole = max(inBase, between);

  vec3 toApex_C = apex_C - rayFrom(p_px);
  float t0 = dot(toApex_C, ray) / dot(ray, ray);
  vec3 o = t0 * ray - toApex_C;  // from the apex to the nearest point of the ray
  float du = dot(ray, axis), ou = dot(o, axis), kk = 1.0 + slope * slope;
  float a = dot(ray, ray) - kk * du * du, b = dot(ray, o) - kk * du * ou, c = dot(o, o) - kk * ou * ou;
  float root = sqrt(max(b * b - a * c, 0.0));
  // Roots without cancellation; `a` changes sign if the ray runs into the cone.
  float q = b > 0.0 ? -b - root : -b + root;
  float r1 = q / (abs(a) > 1e-9 ? a : 1e-9), r2 = abs(q) > 1e-20 ? c / q : r1;
  float first = min(r1, r2), last = max(r1, r2);
  // One of the two may lie beyond the base or on the cone's other half.
  float firstHeight = ou + first * du, lastHeight = ou + last * du, slack = 0.02 * height;
  float tOutside = firstHeight > -1e-4 * height && firstHeight < height + slack ? first : last;
  float tInside = lastHeight > -1e-4 * height && lastHeight < height + slack ? last : first;
  float size = 2.0 * (height + radius);
  float tAxis = dot(clamp(ou, 0.0, height) * axis - o, ray) / dot(ray, ray);
  float tNear = clamp(tOutside, tAxis - size, tAxis + size), tFar = clamp(tInside, tAxis - size, tAxis + size);
  float nearOpacity = coneOpacity(outsideOpacity, rimOpacity, o + tNear * ray, ou + tNear * du, axis, slope, towardEye_C);
  float farOpacity = coneOpacity(insideColor.a, rimOpacity, o + tFar * ray, ou + tFar * du, axis, slope, towardEye_C);
  // Where the base is visible, one of the sides is not.
  float nearCover = max(whole - looksIn * inBase, 0.0), farCover = max(whole - (1.0 - looksIn) * inBase, 0.0);
  colors[slot] = premultiplied(insideColor.rgb, nearOpacity * nearCover);
  depths[slot] = toDepth(t0 + tNear);
  colors[slot + 1] = premultiplied(insideColor.rgb, farOpacity * behindNear(farCover, nearCover, nearOpacity));
  depths[slot + 1] = toDepth(t0 + tFar);
  float halfWidth = 0.5 * lineWidth_px;
  float line = coveredStrip(vec3(-base.xy, halfWidth - base.z), vec3(base.xy, halfWidth + base.z));
  float tBase = t0 + clamp((height - ou) / (abs(du) > 1e-7 ? du : 1e-7), tAxis - size, tAxis + size);
  // The line is drawn in front of the sheet that it borders.
  colors[slot + 2] = premultiplied(lineColor.rgb, lineColor.a * line);
  depths[slot + 2] = toDepth(tBase - lineWidth_px * pixelSize(tBase));
}
