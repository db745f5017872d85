// SPDX-License-Identifier: Apache-2.0
// Declarations of the OSMesa functions that poinsot uses, with the names and values of Mesa 22.3. The header
// GL/osmesa.h is not used, because Mesa 25.1 has removed OSMesa. The library, if present, is opened at run time.
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
