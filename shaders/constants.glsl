// SPDX-License-Identifier: Apache-2.0
// Constants that all pixels of a draw call share, in the order of render/constants.h. llvmpipe (22.3) gathers each
// component of a uniform in a fragment shader lane by lane, in 25 instructions; a flat varying is one broadcast. So vertex
// shaders read the uniforms and hand them on, as far as there are varyings. A division costs as much as ten sums, so
// divisors known beforehand are passed as reciprocals.
#if VERTEX
uniform vec2 pictureSize_px;
uniform vec4 constants[CONSTANTS];
flat out vec4 handedOn[HANDED_ON];

void handOn() {
  for (int i = 0; i < HANDED_ON; ++i) handedOn[i] = constants[i];
}

vec4 constantAt(int i) { return constants[i]; }
#else
flat in vec4 handedOn[HANDED_ON];
#if CONSTANTS > HANDED_ON
uniform vec4 constants[CONSTANTS];

vec4 constantAt(int i) { return i < HANDED_ON ? handedOn[min(i, HANDED_ON - 1)] : constants[i]; }
#else
vec4 constantAt(int i) { return handedOn[i]; }
#endif
#endif

// The picture's constants come first, then the draw call's own.
#define opticalCentre_px constantAt(0).xy
#define pixelAtOne constantAt(0).z           // length of a pixel's side at unit distance; at any distance if orthographic
#define orthographic constantAt(0).w         // 1 for parallel rays, else 0; a factor, as llvmpipe runs both sides of an if
#define layers_px constantAt(1).xy           // top left corner of the solid layers in the picture
#define depthRange constantAt(1).zw          // nearest distance along the view, 1 / (farthest - nearest)
#define lightDirection_C constantAt(2).xyz
#define sharpness constantAt(2).w            // steepness of edges: 1 for pictures, large for hard edges (render/reference.h)

vec4 own(int i) { return constantAt(3 + i); }
mat3 ownMatrix(int i) { return mat3(own(i).xyz, own(i + 1).xyz, own(i + 2).xyz); }
vec3 fourthsOf(int i) { return vec3(own(i).w, own(i + 1).w, own(i + 2).w); }  // w components beside a matrix
