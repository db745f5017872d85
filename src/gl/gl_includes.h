// SPDX-License-Identifier: Apache-2.0
#pragma once

// OpenGL functions are used through this header only. glad generated them; OffscreenContext::makeCurrent() loads
// them for its thread.
#include <glad/gl.h>
