// SPDX-License-Identifier: Apache-2.0
#include "camera.glsl"

uniform vec3 origin_C;
uniform mat3 axes_C;     // takes M to C
uniform mat3 normals_C;  // takes normals from M to C

layout(location = 0) in vec3 position_M;
layout(location = 1) in vec3 normal_M;

out vec3 normalOut_C;
out float distanceOut;  // along the view

void main() {
  vec3 x_C = origin_C + axes_C * position_M;
  float t = -x_C.z;
  float w = mix(t, 1.0, orthographic);
  vec2 p_px = opticalCentre_px * w + focal_px * vec2(x_C.x, -x_C.y);  // times w, as gl_Position is
  float span = depthRange.y - depthRange.x, sum = depthRange.y + depthRange.x;
  float depth = mix(sum * t - 2.0 * depthRange.y * depthRange.x, 2.0 * t - sum, orthographic) / span;
  normalOut_C = normals_C * normal_M;
  distanceOut = t;
  gl_Position = vec4(2.0 * p_px / pictureSize_px - w, depth, w);
}
