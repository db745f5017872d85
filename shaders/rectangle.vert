// A rectangle of pixels, as a strip of four vertices without attributes.
uniform vec2 pictureSize_px;
uniform vec4 bounds_px;  // left, top, right, bottom

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  vec2 p_px = mix(bounds_px.xy, bounds_px.zw, corner);
  gl_Position = vec4(2.0 * p_px / pictureSize_px - 1.0, 0.0, 1.0);
}
