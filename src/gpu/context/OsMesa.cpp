#include <GL/osmesa.h>
#include <dlfcn.h>

#include <vector>

#include "gpu/Context.h"
#include "gpu/GpuError.h"

namespace velum::gpu {

namespace {

/// libOSMesa, opened at run time: recent Mesa releases no longer have it.
struct OsMesaLibrary {
  void* handle = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
  template <class F>
  F find(const char* name) const {
    return handle ? reinterpret_cast<F>(dlsym(handle, name)) : nullptr;
  }
};

const OsMesaLibrary& library() {
  static OsMesaLibrary instance;
  return instance;
}

void* procAddress(const char* name) {
  static auto get = library().find<OSMESAproc (*)(const char*)>("OSMesaGetProcAddress");
  return reinterpret_cast<void*>(get(name));
}

class OsMesaContext : public Context {
 public:
  OsMesaContext() : mPixels(16 * 16 * 4) { make(); }
  ~OsMesaContext() override { destroy(); }
  void makeCurrent() override {
    if (!mContext) return make();  // which it could not before
    auto bind = library().find<GLboolean (*)(::OSMesaContext, void*, GLenum, GLsizei, GLsizei)>("OSMesaMakeCurrent");
    if (!bind(mContext, mPixels.data(), GL_UNSIGNED_BYTE, 16, 16))
      throw GpuError("OSMesa: the context cannot be made current");
    Context::makeCurrent();
  }
  void renew() override {
    destroy();
    make();
  }

 private:
  void make() {
    auto create = library().find<::OSMesaContext (*)(const int*, ::OSMesaContext)>("OSMesaCreateContextAttribs");
    if (!create) throw GpuError("OSMesa: libOSMesa.so.8 is not installed (Debian package libosmesa6)");
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              24,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              4,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              5,
                              0};
    mContext = create(attributes, nullptr);
    if (!mContext) throw TooOld("OSMesa: it offers no OpenGL 4.5 core context");
    OsMesaContext::makeCurrent();
    load(procAddress);
  }
  void destroy() {
    if (!mContext) return;
    library().find<GLboolean (*)(::OSMesaContext, void*, GLenum, GLsizei, GLsizei)>("OSMesaMakeCurrent")(
        nullptr, nullptr, 0, 0, 0);
    library().find<void (*)(::OSMesaContext)>("OSMesaDestroyContext")(mContext);
    mContext = nullptr;
    leave();
  }
  ::OSMesaContext mContext = nullptr;
  std::vector<unsigned char> mPixels;  ///< The default framebuffer, which nothing draws to.
};

}  // namespace

std::unique_ptr<Context> Context::createOsMesa() { return std::make_unique<OsMesaContext>(); }

}  // namespace velum::gpu
