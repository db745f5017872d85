// SPDX-License-Identifier: Apache-2.0
#include "gl/osmesa.h"

#include <array>

#include "core/shared_library.h"
#include "gl/back_ends.h"

namespace poinsot::gl {
namespace {

using core::ErrorKind;

constexpr const char* kOsMesaLibrary = "libOSMesa.so.8";

struct OsMesaFunctions {
  core::SharedLibrary library{kOsMesaLibrary, "libosmesa6 (Mesa 25.1 and later have none; EGL draws as well)",
                              ErrorKind::kGraphics};
  decltype(OSMesaCreateContextAttribs)* createContextAttribs;
  decltype(OSMesaMakeCurrent)* makeCurrent;
  decltype(OSMesaDestroyContext)* destroyContext;
  decltype(OSMesaGetProcAddress)* getProcAddress;
  decltype(OSMesaGetCurrentContext)* getCurrentContext;
  decltype(OSMesaGetColorBuffer)* getColorBuffer;
  decltype(OSMesaGetIntegerv)* getIntegerv;

  OsMesaFunctions() {
    library.load(createContextAttribs, "OSMesaCreateContextAttribs");
    library.load(makeCurrent, "OSMesaMakeCurrent");
    library.load(destroyContext, "OSMesaDestroyContext");
    library.load(getProcAddress, "OSMesaGetProcAddress");
    library.load(getCurrentContext, "OSMesaGetCurrentContext");
    library.load(getColorBuffer, "OSMesaGetColorBuffer");
    library.load(getIntegerv, "OSMesaGetIntegerv");
  }
};

const OsMesaFunctions& osMesa() {
  static const OsMesaFunctions functions;
  return functions;
}

class OsMesaContext final : public NestedContext {
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
    if (!context_) throw core::graphicsError("OSMesa gives no OpenGL 3.3 core context");
  }
  ~OsMesaContext() override {
    leave();
    osMesa().destroyContext(context_);
  }
  const char* backendName() const override { return "osmesa"; }

 private:
  // OSMesa requires memory for a window. One pixel is enough, because drawing goes to framebuffer objects.
  bool bind() override { return osMesa().makeCurrent(context_, windowPixel_.data(), GL_UNSIGNED_BYTE, 1, 1); }
  void unbind() override { osMesa().makeCurrent(nullptr, nullptr, 0, 0, 0); }
  bool isBound() const override { return osMesa().getCurrentContext() == context_; }
  FunctionLoader loader() const override { return reinterpret_cast<FunctionLoader>(osMesa().getProcAddress); }

  OSMesaContext context_ = nullptr;
  std::array<unsigned char, 4> windowPixel_{};
};

}  // namespace

void openOsMesaLibrary() { osMesa(); }

const void* osMesasWord() {
  return core::SharedLibrary::isOpen(kOsMesaLibrary) ? osMesa().getCurrentContext() : nullptr;
}

std::function<void()> callersOsMesaContext() {
  const OSMesaContext context =
      core::SharedLibrary::isOpen(kOsMesaLibrary) ? osMesa().getCurrentContext() : nullptr;
  GLint width = 0, height = 0, format = 0, type = 0;
  void* buffer = nullptr;
  if (!context || !osMesa().getColorBuffer(context, &width, &height, &format, &buffer)) return nullptr;
  osMesa().getIntegerv(OSMESA_TYPE, &type);
  return [=] { osMesa().makeCurrent(context, buffer, static_cast<GLenum>(type), width, height); };
}

std::unique_ptr<OffscreenContext> openOsMesaContext() {
  auto context = std::make_unique<OsMesaContext>();
  makeReady(*context);
  return context;
}

}  // namespace poinsot::gl
