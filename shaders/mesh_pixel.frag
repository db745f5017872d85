// SPDX-License-Identifier: Apache-2.0
#include "emit.glsl"

flat in vec4 shown;
flat in float depth;

void main() { emit(shown.rgb, shown.a, depth); }
