// SPDX-License-Identifier: Apache-2.0
// Parts of OSMesa's interface that are used here, with the names and values of Mesa 22.3. Mesa 25.1 dropped OSMesa
// and its header GL/osmesa.h. The sources build with any version, because the library is opened at run time, if
// present.
#pragma once

#include <glad/gl.h>

using OSMesaContext = struct osmesa_context*;

enum : int {
  OSMESA_RGBA = GL_RGBA,
  OSMESA_FORMAT = 0x22,
  OSMESA_TYPE = 0x23,
  OSMESA_DEPTH_BITS = 0x30,
  OSMESA_STENCIL_BITS = 0x31,
  OSMESA_PROFILE = 0x33,
  OSMESA_CORE_PROFILE = 0x34,
  OSMESA_CONTEXT_MAJOR_VERSION = 0x36,
  OSMESA_CONTEXT_MINOR_VERSION = 0x37,
};

extern "C" {
OSMesaContext OSMesaCreateContextAttribs(const int* attributes, OSMesaContext shares);
GLboolean OSMesaMakeCurrent(OSMesaContext context, void* buffer, GLenum type, GLsizei width, GLsizei height);
void OSMesaDestroyContext(OSMesaContext context);
void (*OSMesaGetProcAddress(const char* name))();
OSMesaContext OSMesaGetCurrentContext();
GLboolean OSMesaGetColorBuffer(OSMesaContext context, GLint* width, GLint* height, GLint* format, void** buffer);
void OSMesaGetIntegerv(GLint name, GLint* value);
}
