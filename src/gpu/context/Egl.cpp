#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "core/Log.h"
#include "gpu/Context.h"
#include "gpu/Gl.h"
#include "gpu/GpuError.h"
#include "gpu/SoftwareDriver.h"

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

/// How long a driver may take to come back after a reset.
constexpr auto kLongestReset = std::chrono::seconds(5);
constexpr auto kPause = std::chrono::milliseconds(10);

class EglContext : public Context {
 public:
  EglContext();
  ~EglContext() override { destroy(); }
  void makeCurrent() override;
  void renew() override;

 private:
  struct Displays {
    std::vector<EGLDisplay> usual, software;
  };
  static Displays displays();
  void make();
  void destroy();
  bool open(EGLDisplay display);
  bool tryOpen(EGLDisplay display);
  EGLContext create(EGLDisplay display, EGLConfig config, int major, int minor, bool asksForWords, bool isRobust) const;
  EGLDisplay mDisplay = EGL_NO_DISPLAY;
  EGLContext mContext = EGL_NO_CONTEXT;
  std::string mTooOld;  ///< What the first driver that offers too little has said; empty: there was none.
};

EglContext::EglContext() {
  if (!library().getProcAddress) throw GpuError("EGL: libEGL.so.1 is not installed (Debian package libegl1)");
  try {
    make();
  } catch (...) {
    destroy();
    throw;
  }
}

/// Mesa's software driver comes last. Which of its software drivers that is, is a display's as it is opened first.
void EglContext::make() {
  auto [usual, software] = displays();
  auto opens = [this](EGLDisplay display) { return open(display); };
  if (std::any_of(usual.begin(), usual.end(), opens)) return;
  const char* driver = std::getenv("GALLIUM_DRIVER");
  if (driver && *driver) {
    if (mTooOld.empty()) mTooOld = fmt::format("the driver that GALLIUM_DRIVER names ({}) makes no OpenGL", driver);
    ::setenv("GALLIUM_DRIVER", "llvmpipe", 1);
  }
  bool isOpen = std::any_of(software.begin(), software.end(), opens);
  if (isOpen && !mTooOld.empty()) warnOfSoftware(mTooOld);
  if (isOpen) return;
  if (!mTooOld.empty()) throw TooOld(mTooOld);
  throw GpuError(
      "EGL: no display offers an OpenGL 4.5 core context (Debian package libgl1-mesa-dri has a software one)");
}

void EglContext::destroy() {
  if (mContext == EGL_NO_CONTEXT) return;
  library().find<PFNEGLMAKECURRENTPROC>("eglMakeCurrent")(mDisplay, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  library().find<PFNEGLDESTROYCONTEXTPROC>("eglDestroyContext")(mDisplay, mContext);
  mContext = EGL_NO_CONTEXT;
  leave();
}

void EglContext::makeCurrent() {
  if (mContext == EGL_NO_CONTEXT) return make();  // which it could not before
  auto makeCurrentFn = library().find<PFNEGLMAKECURRENTPROC>("eglMakeCurrent");
  if (makeCurrentFn(mDisplay, EGL_NO_SURFACE, EGL_NO_SURFACE, mContext)) return Context::makeCurrent();
  bool isLost = library().find<PFNEGLGETERRORPROC>("eglGetError")() == EGL_CONTEXT_LOST;
  if (!isLost) throw GpuError("EGL: the context cannot be made current");
  renew();
}

/// As soon as the driver has come back; another one only where it does not.
void EglContext::renew() {
  auto start = std::chrono::steady_clock::now();
  while (hasGl() && gl().GetGraphicsResetStatus() != GL_NO_ERROR &&
         std::chrono::steady_clock::now() - start < kLongestReset)
    std::this_thread::sleep_for(kPause);
  std::string before = limits().renderer;
  destroy();
  while (!open(mDisplay) && std::chrono::steady_clock::now() - start < kLongestReset)
    std::this_thread::sleep_for(kPause);
  if (mContext == EGL_NO_CONTEXT) make();
  if (limits().renderer != before)
    log::warning(fmt::format("the graphics driver has not come back: {} draws instead", limits().renderer));
}

/// Real devices first, then Mesa's surfaceless platform; devices that are software stand in for them.
EglContext::Displays EglContext::displays() {
  Displays found;
  auto getPlatformDisplay = library().find<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  auto queryDevices = library().find<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  auto queryDeviceString = library().find<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  if (!getPlatformDisplay) return found;
  EGLDeviceEXT devices[16];
  EGLint count = 0;
  if (!queryDevices || !queryDeviceString || !queryDevices(16, devices, &count)) count = 0;
  for (int i = 0; i < count; ++i) {
    const char* extensions = queryDeviceString(devices[i], EGL_EXTENSIONS);
    bool software =
        extensions && std::string_view(extensions).find("EGL_MESA_device_software") != std::string_view::npos;
    (software ? found.software : found.usual)
        .push_back(getPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
  }
  found.usual.push_back(getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  return found;
}

/// @param isRobust  told of resets, where shaders do not reach beyond a buffer either
EGLContext EglContext::create(EGLDisplay display, EGLConfig config, int major, int minor, bool asksForWords,
                              bool isRobust) const {
  std::vector<EGLint> attributes{EGL_CONTEXT_MAJOR_VERSION,       major,
                                 EGL_CONTEXT_MINOR_VERSION,       minor,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT};
  if (asksForWords) attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE});
  if (isRobust)
    attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_ROBUST_ACCESS, EGL_TRUE,
                                         EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY, EGL_LOSE_CONTEXT_ON_RESET});
  attributes.push_back(EGL_NONE);
  return library().find<PFNEGLCREATECONTEXTPROC>("eglCreateContext")(display, config, EGL_NO_CONTEXT,
                                                                     attributes.data());
}

bool EglContext::open(EGLDisplay display) {
  try {
    return tryOpen(display);
  } catch (const TooOld& error) {
    destroy();
    if (mTooOld.empty()) mTooOld = error.what();
    return false;
  }
}

bool EglContext::tryOpen(EGLDisplay display) {
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
  mDisplay = display;
  // Where asserts are checked drivers say all that they have to say; not every EGL knows how to ask for it, nor for
  // news of resets.
  for (bool isRobust : {true, false})
    for (bool asksForWords : {kChecksAsserts, false})
      if (mContext == EGL_NO_CONTEXT) mContext = create(display, config, 4, 5, asksForWords, isRobust);
  // Who says what it offers instead, is asked.
  if (mContext == EGL_NO_CONTEXT) mContext = create(display, config, 3, 2, false, false);
  if (mContext == EGL_NO_CONTEXT) return false;
  if (!egl.find<PFNEGLMAKECURRENTPROC>("eglMakeCurrent")(display, EGL_NO_SURFACE, EGL_NO_SURFACE, mContext)) {
    destroy();
    return false;
  }
  load(procAddress);
  return true;
}

}  // namespace

std::unique_ptr<Context> Context::createEgl() { return std::make_unique<EglContext>(); }

}  // namespace velum::gpu
