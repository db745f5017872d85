// SPDX-License-Identifier: Apache-2.0
// Stands for a program that was not made for poinsot: draws one triangle with OSMesa or EGL, whichever the argument
// names. Prints the version and renderer of OpenGL, a sum of the pixels, and the path of each library that is loaded.
// It is linked with glibc only, and opens the rest by name, as libglvnd and many programs do.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <link.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { kSize = 64, kColourBuffer = 0x4000, kTriangles = 4, kRgba = 0x1908, kBytes = 0x1401, kRenderer = 0x1F01, kVersion = 0x1F02 };

typedef void (*Function)(void);
typedef Function (*Finder)(const char*);

static unsigned char pixels[kSize * kSize * 4];

static void* must(void* found, const char* name) {
  if (!found) {
    fprintf(stderr, "%s: %s\n", name, dlerror());
    exit(1);
  }
  return found;
}

static Function from(void* library, const char* name) {
  Function function;
  *(void**)&function = must(dlsym(library, name), name);
  return function;
}

static void draw(Finder find) {
  ((void (*)(unsigned))find("glClear"))(kColourBuffer);
  ((void (*)(unsigned))find("glBegin"))(kTriangles);
  for (int corner = 0; corner < 3; ++corner) {
    ((void (*)(float, float, float))find("glColor3f"))(corner == 0, corner == 1, corner == 2);
    ((void (*)(float, float))find("glVertex2f"))(0.9F - 0.7F * corner, corner == 1 ? 0.8F : -0.6F);
  }
  find("glEnd")();
  ((void (*)(int, int, int, int, unsigned, unsigned, void*))find("glReadPixels"))(0, 0, kSize, kSize, kRgba, kBytes, pixels);
  const unsigned char* (*text)(unsigned) = (const unsigned char* (*)(unsigned))find("glGetString");
  unsigned sum = 0;
  for (unsigned i = 0; i < sizeof pixels; ++i) sum = i % 4 == 3 ? sum : sum * 31 + pixels[i];  // EGL may draw without alpha
  printf("version: %s\nrenderer: %s\npixels: %u\n", text(kVersion), text(kRenderer), sum);
}

static void drawWithOsMesa(void) {
  void* mesa = must(dlopen("libOSMesa.so.8", RTLD_NOW), "libOSMesa.so.8");
  void* context = ((void* (*)(unsigned, void*))from(mesa, "OSMesaCreateContext"))(kRgba, NULL);
  ((char (*)(void*, void*, unsigned, int, int))from(mesa, "OSMesaMakeCurrent"))(context, pixels, kBytes, kSize, kSize);
  draw((Finder)from(mesa, "OSMesaGetProcAddress"));
}

static void drawWithEgl(void) {
  void* egl = must(dlopen("libEGL.so.1", RTLD_NOW), "libEGL.so.1");
  const int wanted[] = {0x3033, 1, 0x3040, 8, 0x3038};        // pbuffer, OpenGL
  const int size[] = {0x3057, kSize, 0x3056, kSize, 0x3038};  // width, height
  void *configs[99], *config = NULL, *display = ((void* (*)(void*))from(egl, "eglGetDisplay"))(NULL);
  int count = 0, red = 0;
  ((unsigned (*)(void*, int*, int*))from(egl, "eglInitialize"))(display, NULL, NULL);
  ((unsigned (*)(unsigned))from(egl, "eglBindAPI"))(0x30A2);
  ((unsigned (*)(void*, const int*, void**, int, int*))from(egl, "eglChooseConfig"))(display, wanted, configs, 99, &count);
  for (int i = 0; i < count && red != 8; ++i) {  // those of more bits come first
    ((unsigned (*)(void*, void*, int, int*))from(egl, "eglGetConfigAttrib"))(display, config = configs[i], 0x3024, &red);
  }
  must(red == 8 ? config : NULL, "a config of 8 bits");
  void* surface = ((void* (*)(void*, void*, const int*))from(egl, "eglCreatePbufferSurface"))(display, config, size);
  void* context = ((void* (*)(void*, void*, void*, const int*))from(egl, "eglCreateContext"))(display, config, NULL, NULL);
  ((unsigned (*)(void*, void*, void*, void*))from(egl, "eglMakeCurrent"))(display, surface, surface, context);
  draw((Finder)from(egl, "eglGetProcAddress"));
}

static int printPath(struct dl_phdr_info* library, size_t size, void* unused) {
  (void)size;
  (void)unused;
  if (*library->dlpi_name) printf("library: %s\n", library->dlpi_name);
  return 0;
}

int main(int count, char** words) {
  must(count == 2 ? words[1] : NULL, "osmesa or egl");
  if (strcmp(words[1], "egl") == 0) {
    drawWithEgl();
    must(dlopen("libGLX_mesa.so.0", RTLD_NOW), "libGLX_mesa.so.0");  // would need an X server to draw
  } else {
    drawWithOsMesa();
  }
  dl_iterate_phdr(printPath, NULL);
  return 0;
}
