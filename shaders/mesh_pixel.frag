// SPDX-License-Identifier: Apache-2.0
#include "emit.glsl"

flat in vec4 shown;
flat in float depth;
flat in float solidOut;

void main() { emit(solidOut, shown.rgb, shown.a, depth); }
