// SPDX-License-Identifier: Apache-2.0
// Lighting in linear light. The light travels with the camera, so that a body looks alike from every side.
struct Material {
  vec3 color;
  float gloss;
};

// Returns the light from a surface; n_C and towardEye_C are unit vectors. Wrapped diffuse light keeps the shadow side
// readable on a projector. The highlight is small and white, so that hue is lost nowhere else.
vec3 shade(Material m, vec3 n_C, vec3 towardEye_C) {
  float wrapped = 0.5 + 0.5 * dot(n_C, lightDirection_C);
  float sky = 0.5 + 0.5 * n_C.y;
  vec3 diffuse = m.color * (0.24 + 0.14 * sky + 0.82 * wrapped * wrapped);
  vec3 halfway = normalize(lightDirection_C + towardEye_C);
  float h2 = dot(n_C, halfway);
  h2 *= h2;
  float h8 = h2 * h2 * h2 * h2, highlight = h8 * h8 * h8 * h8 * h8;  // to the 40th power; pow costs a logarithm
  return diffuse + vec3(0.45 * m.gloss * highlight);
}

// Bends an interpolated normal that has turned away from the eye back to the rim.
vec3 turnedToEye(vec3 n_C, vec3 towardEye_C) {
  float facing = dot(n_C, towardEye_C);
  return facing < 0.0 ? normalize(n_C - facing * towardEye_C) : n_C;
}
