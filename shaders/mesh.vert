// SPDX-License-Identifier: Apache-2.0
#include "constants.glsl"
#include "camera.glsl"

layout(location = 0) in vec3 position_M;
layout(location = 1) in vec3 normal_M;

out vec3 normalOut_C;
out float distanceOut;  // along the view

void main() {
  handOn();
  vec3 origin_C = own(0).xyz;
  mat3 axes_C = ownMatrix(1), normals_C = ownMatrix(4);  // take positions and normals from M to C
  vec3 x_C = origin_C + axes_C * position_M;
  float t = -x_C.z;
  float w = mix(t, 1.0, orthographic);
  vec2 p_px = opticalCentre_px * w + vec2(x_C.x, -x_C.y) / pixelAtOne;  // times w, like gl_Position
  float near = depthRange.x, span = 1.0 / depthRange.y, far = near + span;
  float depth = mix((far + near) * t - 2.0 * far * near, 2.0 * t - far - near, orthographic) / span;
  normalOut_C = normals_C * normal_M;
  distanceOut = t;
  gl_Position = vec4(2.0 * p_px / pictureSize_px - w, depth, w);
}
