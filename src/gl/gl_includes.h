// SPDX-License-Identifier: Apache-2.0
#pragma once

// Declares the OpenGL functions. All sources must include this header instead of another OpenGL header. The
// functions come from glad; OffscreenContext::makeCurrent() loads them for the calling thread.
#include <glad/gl.h>
