// SPDX-License-Identifier: Apache-2.0
// Convex polygon of SIDES sides. From i + 5 on there is a constant per side, with the x of its first corner in w; then the
// corners' y.
vec2 polygonCorner_px(int i, int k) { return vec2(own(i + 5 + k).w, own(i + 5 + SIDES + k / 4)[k % 4]); }

void addPolygon(int i, int slot, vec2 p_px, vec3 ray) {
  vec3 point_C = own(i).xyz, normal_C = own(i + 1).xyz;
  float lineWidth_px = own(i).w;
  vec2 reach = own(i + 4).xy;  // distances of the nearest and of the farthest corner
  vec4 lineColor = own(i + 3);
  vec3 nearest = edgeAt(own(i + 5).xyz, p_px);
  float cover = 0.0;
#define ADD_SIDE(k) \
  nearest = outerOf(nearest, edgeAt(own(i + 5 + k).xyz, p_px)); \
  cover += areaRightOf(polygonCorner_px(i, k), polygonCorner_px(i, (k + 1) % SIDES), p_px);
  EACH_SIDE(ADD_SIDE)
  float along = dot(normal_C, ray);
  float t = dot(normal_C, point_C - rayFrom(p_px)) / (abs(along) > 1e-7 ? along : 1e-7);
  float border = covered(vec3(-nearest.xy, lineWidth_px - nearest.z));
  vec4 color = layOver(premultiplied(lineColor.rgb, lineColor.a * border), premultiplied(own(i + 2)));
  colors[slot] = color * min(abs(cover), 1.0);
  depths[slot] = toDepth(clamp(t, reach.x, reach.y));
}
