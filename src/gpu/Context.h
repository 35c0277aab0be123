#pragma once
#include <cstddef>
#include <memory>
#include <string>

#include "core/Fields.h"

namespace velum::gpu {

enum class ContextKind { Auto, Egl, OsMesa };

}  // namespace velum::gpu

namespace velum {

template <>
struct EnumNames<gpu::ContextKind> {
  static constexpr std::string_view kNames[] = {"auto", "egl", "osmesa"};
};

}  // namespace velum

namespace velum::gpu {

/// What the driver offers, read once.
struct Limits {
  std::string renderer;           ///< GL_RENDERER
  std::string version;            ///< GL_VERSION
  int texture3d = 0;              ///< Largest side of a 3D texture, texels.
  int texture2d = 0;              ///< Largest side of a 2D texture, texels.
  std::size_t textureBuffer = 0;  ///< Most texels of a buffer's texture. VELUM_MAX_TEXTURE_BUFFER overrides.
  std::size_t storageBlock = 0;   ///< Most bytes of a storage block. VELUM_MAX_STORAGE_BLOCK overrides.
  std::size_t memoryBytes = 0;    ///< Memory that textures may take: the card's free memory, or half of the machine's
                                ///< memory where the driver is software or does not say. VELUM_GPU_MEMORY_MB overrides.
  bool isSoftware = false;  ///< llvmpipe and the like: the processor draws. VELUM_SOFTWARE_DRIVER overrides: 0, 1.
};

/// An OpenGL 4.5 core context and its table of functions.
///
/// A context belongs to one thread at a time: makeCurrent() binds it, and every object of this module works on the
/// thread's current context.
class Context {
 public:
  /// Resolves a GL function by name in the context that is current.
  using ProcAddress = void* (*)(const char* name);
  /// Tells which context of the window system is current on this thread.
  using Current = const void* (*)();

  /// EGL without a window system (devices, then the surfaceless platform); where none of its drivers offers enough,
  /// Mesa's software driver, and a warning says so. @throw GpuError
  static std::unique_ptr<Context> createEgl();
  /// Mesa's off-screen software renderer. @throw GpuError
  static std::unique_ptr<Context> createOsMesa();
  /// Auto: the kind that VELUM_CONTEXT names, else EGL, else OSMesa. The context is current on return.
  /// @throw GpuError with the reasons of both; ArgumentError when VELUM_CONTEXT names none
  static std::unique_ptr<Context> create(ContextKind kind);
  /// What VELUM_CONTEXT names: all that is drawn without a window's context, by whichever program, is drawn so; Auto
  /// where it names none. @throw ArgumentError when it names something else
  static ContextKind kindOfEnvironment();
  /// Takes over a context that a window made and that is current now; does not destroy it. @throw GpuError From then on
  /// the context must be current, as @p current tells, wherever GL is called. Other contexts of the window share its
  /// programs and textures; objects deleted while one of those is current would be the wrong ones, and such deletions
  /// meet bugs of drivers.
  static std::unique_ptr<Context> adopt(ProcAddress procAddress, Current current);

  virtual ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  /// Binds the context and its function table to this thread. An adopted context must have been made current by the
  /// window before.
  virtual void makeCurrent();
  /// Makes the context anew, after the driver has lost it, and binds it. Objects made in it before are no more, and
  /// contextNumber() is another one. @throw ContextLost for a context of a window, which the window has to make anew
  virtual void renew();
  const Limits& limits() const { return mLimits; }
  /// How many messages drivers have sent so far, in any context of the process, about errors, undefined behaviour or
  /// anything of high severity. Each is logged, too; tests want none (VELUM_DRIVER_ERRORS=fatal ends the program at the
  /// first). Requests that a driver refuses and that become a GpuError are not counted. Any thread.
  static int errorCount();

 protected:
  Context();
  /// The context is no more, or not yet: if it is bound to this thread, nothing is from now on.
  void leave();
  /// Fills the function table and the limits. @throw TooOld when a function is missing or the version is below 4.5
  void load(ProcAddress procAddress, Current current = nullptr);

 private:
  void readLimits();
  struct Impl;
  std::unique_ptr<Impl> mImpl;
  Limits mLimits;
};

}  // namespace velum::gpu
