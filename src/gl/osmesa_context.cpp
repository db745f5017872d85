// SPDX-License-Identifier: Apache-2.0
#include <GL/osmesa.h>

#include <array>

#include "core/shared_library.h"
#include "gl/back_ends.h"

namespace poinsot::gl {
namespace {

using core::Error;
using core::ErrorKind;

struct OsMesaFunctions {
  core::SharedLibrary library{"libOSMesa.so.8", "libosmesa6", ErrorKind::kGraphics};
  decltype(OSMesaCreateContextAttribs)* createContextAttribs;
  decltype(OSMesaMakeCurrent)* makeCurrent;
  decltype(OSMesaDestroyContext)* destroyContext;
  decltype(OSMesaGetProcAddress)* getProcAddress;

  OsMesaFunctions() {
    library.load(createContextAttribs, "OSMesaCreateContextAttribs");
    library.load(makeCurrent, "OSMesaMakeCurrent");
    library.load(destroyContext, "OSMesaDestroyContext");
    library.load(getProcAddress, "OSMesaGetProcAddress");
  }
};

const OsMesaFunctions& osMesa() {
  static const OsMesaFunctions functions;
  return functions;
}

class OsMesaContext final : public OffscreenContext {
 public:
  OsMesaContext() {
    constexpr int kAttributes[] = {OSMESA_FORMAT,
                                   OSMESA_RGBA,
                                   OSMESA_DEPTH_BITS,
                                   0,
                                   OSMESA_STENCIL_BITS,
                                   0,
                                   OSMESA_PROFILE,
                                   OSMESA_CORE_PROFILE,
                                   OSMESA_CONTEXT_MAJOR_VERSION,
                                   3,
                                   OSMESA_CONTEXT_MINOR_VERSION,
                                   3,
                                   0};
    context_ = osMesa().createContextAttribs(kAttributes, nullptr);
    if (!context_) throw Error(ErrorKind::kGraphics, "OSMesa gives no OpenGL 3.3 core context");
    // OSMesa wants a window of its own; drawing goes to framebuffer objects, so one pixel is enough.
    if (!osMesa().makeCurrent(context_, windowPixel_.data(), GL_UNSIGNED_BYTE, 1, 1)) {
      osMesa().destroyContext(context_);
      throw Error(ErrorKind::kGraphics, "OSMesa cannot make its context current");
    }
  }
  ~OsMesaContext() override {
    osMesa().makeCurrent(nullptr, nullptr, 0, 0, 0);
    osMesa().destroyContext(context_);
  }
  const char* backendName() const override { return "osmesa"; }

 private:
  OSMesaContext context_ = nullptr;
  std::array<unsigned char, 4> windowPixel_{};
};

}  // namespace

void openOsMesaLibrary() { osMesa(); }

std::unique_ptr<OffscreenContext> openOsMesaContext() {
  auto context = std::make_unique<OsMesaContext>();
  makeReady(reinterpret_cast<FunctionLoader>(osMesa().getProcAddress));
  return context;
}

}  // namespace poinsot::gl
