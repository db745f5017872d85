// SPDX-License-Identifier: Apache-2.0
// Converts linear light to sRGB. pow would cost a logarithm and an exponential. The polynomial in the fourth root equals
// 1.055 c^(1/2.4) - 0.055 within 1.7e-6 from where the curve begins, which is a tenth of a step of 16 bits.
vec3 toSrgb(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  vec3 r = sqrt(sqrt(c));
  vec3 curve = 0.657188366 + r * (-0.318416035 + r * 0.068207989);
  curve = -0.059546608 + r * (0.139604128 + r * (1.365921083 + r * (-0.852957521 + r * curve)));
  return mix(curve, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308))));
}
