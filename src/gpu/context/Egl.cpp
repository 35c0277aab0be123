#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>
#include <fmt/format.h>

#include <vector>

#include "gpu/Context.h"
#include "gpu/GpuError.h"

namespace velum::gpu {

namespace {

#ifdef NDEBUG
constexpr bool kChecksAsserts = false;
#else
constexpr bool kChecksAsserts = true;
#endif

/// libEGL, opened at run time, so that a machine without it can still use OSMesa.
struct EglLibrary {
  void* handle = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  PFNEGLGETPROCADDRESSPROC getProcAddress =
      handle ? reinterpret_cast<PFNEGLGETPROCADDRESSPROC>(dlsym(handle, "eglGetProcAddress")) : nullptr;
  template <class F>
  F find(const char* name) const {
    void* symbol = dlsym(handle, name);
    return reinterpret_cast<F>(symbol ? symbol : reinterpret_cast<void*>(getProcAddress(name)));
  }
};

const EglLibrary& library() {
  static EglLibrary instance;
  return instance;
}

void* procAddress(const char* name) { return reinterpret_cast<void*>(library().getProcAddress(name)); }

class EglContext : public Context {
 public:
  EglContext();
  ~EglContext() override;
  void makeCurrent() override;

 private:
  std::vector<EGLDisplay> displays() const;
  bool open(EGLDisplay display);
  EGLDisplay mDisplay = EGL_NO_DISPLAY;
  EGLContext mContext = EGL_NO_CONTEXT;
};

EglContext::EglContext() {
  if (!library().getProcAddress) throw GpuError("EGL: libEGL.so.1 is not installed (Debian package libegl1)");
  for (EGLDisplay display : displays())
    if (open(display)) break;
  if (mContext == EGL_NO_CONTEXT)
    throw GpuError(
        "EGL: no display offers an OpenGL 4.5 core context (Debian package libgl1-mesa-dri has a software one)");
  EglContext::makeCurrent();
  load(procAddress);
}

EglContext::~EglContext() {
  auto destroy = library().find<PFNEGLDESTROYCONTEXTPROC>("eglDestroyContext");
  auto makeCurrentFn = library().find<PFNEGLMAKECURRENTPROC>("eglMakeCurrent");
  if (mContext == EGL_NO_CONTEXT) return;
  makeCurrentFn(mDisplay, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  destroy(mDisplay, mContext);
}

void EglContext::makeCurrent() {
  auto makeCurrentFn = library().find<PFNEGLMAKECURRENTPROC>("eglMakeCurrent");
  if (!makeCurrentFn(mDisplay, EGL_NO_SURFACE, EGL_NO_SURFACE, mContext))
    throw GpuError("EGL: the context cannot be made current");
  Context::makeCurrent();
}

/// Real devices first, then Mesa's surfaceless platform, then the default display.
std::vector<EGLDisplay> EglContext::displays() const {
  std::vector<EGLDisplay> found;
  auto getPlatformDisplay = library().find<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  auto queryDevices = library().find<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  auto queryDeviceString = library().find<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  EGLDeviceEXT devices[16];
  EGLint count = 0;
  if (getPlatformDisplay && queryDevices && queryDeviceString && queryDevices(16, devices, &count)) {
    for (int i = 0; i < count; ++i) {
      const char* extensions = queryDeviceString(devices[i], EGL_EXTENSIONS);
      bool software =
          extensions && std::string_view(extensions).find("EGL_MESA_device_software") != std::string_view::npos;
      if (!software) found.push_back(getPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
    }
  }
  if (getPlatformDisplay)
    found.push_back(getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  for (int i = 0; i < count; ++i) found.push_back(getPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
  return found;
}

bool EglContext::open(EGLDisplay display) {
  const auto& egl = library();
  if (display == EGL_NO_DISPLAY || !egl.find<PFNEGLINITIALIZEPROC>("eglInitialize")(display, nullptr, nullptr))
    return false;
  const EGLint configAttributes[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint configCount = 0;
  if (!egl.find<PFNEGLCHOOSECONFIGPROC>("eglChooseConfig")(display, configAttributes, &config, 1, &configCount) ||
      configCount < 1)
    return false;
  if (!egl.find<PFNEGLBINDAPIPROC>("eglBindAPI")(EGL_OPENGL_API)) return false;
  auto create = [&](EGLint asksForWords) {
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 4,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 5,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 asksForWords,
                                 EGL_TRUE,
                                 EGL_NONE};
    return egl.find<PFNEGLCREATECONTEXTPROC>("eglCreateContext")(display, config, EGL_NO_CONTEXT, attributes);
  };
  // Where asserts are checked drivers say all that they have to say; not every EGL knows how to ask for it.
  mContext = kChecksAsserts ? create(EGL_CONTEXT_OPENGL_DEBUG) : EGL_NO_CONTEXT;
  if (mContext == EGL_NO_CONTEXT) mContext = create(EGL_NONE);
  mDisplay = display;
  return mContext != EGL_NO_CONTEXT;
}

}  // namespace

std::unique_ptr<Context> Context::createEgl() { return std::make_unique<EglContext>(); }

}  // namespace velum::gpu
