#include "gpu/Context.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <cstring>

#include "core/Assert.h"
#include "core/Error.h"
#include "core/Log.h"
#include "gpu/Gl.h"
#include "gpu/GpuError.h"
#include "gpu/SoftwareDriver.h"

namespace velum::gpu {

namespace {

thread_local const GlTable* tGl = nullptr;
std::atomic<unsigned> gContexts{0};  // how many there have been

constexpr GLenum kMemoryFreeNvx = 0x9049;  // GL_GPU_MEMORY_INFO_CURRENT_AVAILABLE_VIDMEM_NVX, kibibytes

constexpr const char* kParallelCompile = "GL_KHR_parallel_shader_compile";

std::atomic<int> gErrors{0};      // of all contexts
thread_local int tMayRefuse = 0;  // how many MayRefuse live

/// What is wrong by the driver's word, whatever the severity: Mesa and NVIDIA report errors as severe, NVIDIA what is
/// undefined as of medium severity. Hints for speed, of up to medium severity, are none.
bool isError(GLenum type, GLenum severity) {
  return type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR || severity == GL_DEBUG_SEVERITY_HIGH;
}

/// VELUM_DRIVER_ERRORS=fatal: for tests of whole programs, and to see in a debugger who did it.
bool areErrorsFatal() {
  const char* text = std::getenv("VELUM_DRIVER_ERRORS");
  return text && std::string_view(text) == "fatal";
}

void APIENTRY onMessage(GLenum, GLenum type, GLuint, GLenum severity, GLsizei length, const GLchar* text, const void*) {
  // A lost context refuses everything, until somebody asks whether it is lost: see Loss.h.
  if (tGl && std::strstr(text, "CONTEXT_LOST")) tGl->isLost = true;
  if (tGl && tGl->isLost) return;
  if (!isError(type, severity) || (tMayRefuse > 0 && type != GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR)) return;
  ++gErrors;
  log::warning(fmt::format("OpenGL: {}", std::string_view(text, length < 0 ? std::strlen(text) : std::size_t(length))));
  if (areErrorsFatal()) std::_Exit(static_cast<int>(ExitCode::Gpu));
}

std::string glString(const GlTable& table, GLenum name) {
  const auto* text = table.GetString(name);
  return text ? reinterpret_cast<const char*>(text) : "";
}

/// Has the driver compile on as many threads of its own as it likes. @return true where it can
bool compileBeside(const GlTable& table, Context::ProcAddress procAddress) {
  GLint count = 0;
  table.GetIntegerv(GL_NUM_EXTENSIONS, &count);
  bool can = false;
  for (GLint i = 0; i < count && !can; ++i)
    can = std::strcmp(reinterpret_cast<const char*>(table.GetStringi(GL_EXTENSIONS, GLuint(i))), kParallelCompile) == 0;
  auto setThreads =
      reinterpret_cast<void(APIENTRY*)(GLuint)>(can ? procAddress("glMaxShaderCompilerThreadsKHR") : nullptr);
  if (setThreads) setThreads(0xffffffffu);
  return setThreads != nullptr;
}

std::size_t memoryFor(const GlTable& table, bool isSoftware) {
  if (const char* text = std::getenv("VELUM_GPU_MEMORY_MB")) return std::size_t(std::strtoull(text, nullptr, 10)) << 20;
  if (!isSoftware) {
    GLint kibibytes = 0;
    table.GetIntegerv(kMemoryFreeNvx, &kibibytes);
    bool known = table.GetError() == GL_NO_ERROR && kibibytes > 0;
    if (known) return std::size_t(kibibytes) * 1024 * 3 / 4;
  }
  std::size_t machine = std::size_t(sysconf(_SC_PHYS_PAGES)) * std::size_t(sysconf(_SC_PAGESIZE));
  return isSoftware ? machine / 2 : std::size_t(2) << 30;
}

}  // namespace

const GlTable& gl() {
  VELUM_ASSERT(tGl, "GL is called on the thread whose context is current");
  VELUM_ASSERT(!tGl->current || tGl->current() == tGl->context, "GL is called in the context that was adopted");
  return *tGl;
}
bool hasGl() { return tGl != nullptr; }
void setGl(const GlTable* table) { tGl = table; }

MayRefuse::MayRefuse() { ++tMayRefuse; }
MayRefuse::~MayRefuse() { --tMayRefuse; }

struct Context::Impl {
  GlTable table;
};

Context::Context() : mImpl(std::make_unique<Impl>()) {}

Context::~Context() { leave(); }

void Context::leave() {
  if (tGl == &mImpl->table) tGl = nullptr;
}

void Context::makeCurrent() { setGl(&mImpl->table); }

void Context::renew() { throw ContextLost("the graphics driver was reset: the window has to be drawn anew"); }

int Context::errorCount() { return gErrors; }

void Context::readLimits() {
  const GlTable& table = mImpl->table;
  mLimits.renderer = glString(table, GL_RENDERER);
  mLimits.version = glString(table, GL_VERSION);
  mLimits.isSoftware =
      mLimits.renderer.find("llvmpipe") != std::string::npos || mLimits.renderer.find("softpipe") != std::string::npos;
  if (const char* text = std::getenv("VELUM_SOFTWARE_DRIVER")) mLimits.isSoftware = std::atoi(text) != 0;
  table.GetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &mLimits.texture3d);
  table.GetIntegerv(GL_MAX_TEXTURE_SIZE, &mLimits.texture2d);
  int textureBuffer = 0;
  table.GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &textureBuffer);
  if (const char* text = std::getenv("VELUM_MAX_TEXTURE_BUFFER")) textureBuffer = std::atoi(text);
  mLimits.textureBuffer = std::size_t(std::max(0, textureBuffer));
  int storageBlock = 0;
  table.GetIntegerv(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &storageBlock);
  if (const char* text = std::getenv("VELUM_MAX_STORAGE_BLOCK")) storageBlock = std::atoi(text);
  mLimits.storageBlock = std::size_t(std::max(0, storageBlock));
  if (const char* text = std::getenv("VELUM_MAX_TEXTURE_3D")) mLimits.texture3d = std::max(16, std::atoi(text));
  mLimits.memoryBytes = memoryFor(table, mLimits.isSoftware);
}

void Context::load(ProcAddress procAddress, Current current) {
  GlTable& table = mImpl->table;
  table.current = current;
  table.context = current ? current() : nullptr;
  const char* lacks = nullptr;
#define VELUM_GL_LOAD(type, name)                               \
  table.name = reinterpret_cast<type>(procAddress("gl" #name)); \
  if (!table.name) lacks = "gl" #name;
  VELUM_GL_FUNCTIONS(VELUM_GL_LOAD)
#undef VELUM_GL_LOAD
  if (!table.GetIntegerv || !table.GetString) throw TooOld(fmt::format("the graphics driver has no {}", lacks));
  GLint major = 0, minor = 0;
  table.GetIntegerv(GL_MAJOR_VERSION, &major);
  table.GetIntegerv(GL_MINOR_VERSION, &minor);
  std::string renderer = glString(table, GL_RENDERER);
  if (major * 10 + minor < 45) throw TooOld(fmt::format("{} offers OpenGL {}.{}", renderer, major, minor));
  if (lacks) throw TooOld(fmt::format("{} lacks {} of OpenGL 4.5", renderer, lacks));
  // A context that is made anew has the limits of the one before: pictures are to be the same.
  if (renderer != mLimits.renderer) readLimits();
  table.limits = &mLimits;
  table.owner = this;
  table.number = ++gContexts;
  table.isLost = false;
  table.compilesBeside = compileBeside(table, procAddress);
  table.Enable(GL_DEBUG_OUTPUT);
  table.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  table.DebugMessageCallback(onMessage, nullptr);
  table.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  table.PixelStorei(GL_PACK_ALIGNMENT, 1);
  table.CreateVertexArrays(1, &table.emptyVertexArray);
  setGl(&table);
  log::info(fmt::format("OpenGL: {} ({})", mLimits.renderer, mLimits.version));
}

ContextKind Context::kindOfEnvironment() {
  const char* text = std::getenv("VELUM_CONTEXT");
  if (!text || !*text) return ContextKind::Auto;
  if (auto kind = enumValue<ContextKind>(text)) return *kind;
  throw ArgumentError(fmt::format("VELUM_CONTEXT: '{}' is not one of auto, egl, osmesa", text));
}

std::unique_ptr<Context> Context::create(ContextKind kind) {
  if (kind == ContextKind::Auto) kind = kindOfEnvironment();
  if (kind == ContextKind::OsMesa) {
    try {
      return createOsMesa();
    } catch (const TooOld& error) {
      throw GpuError(nothingInstead(error.what(), {}));
    }
  }
  std::string eglSays, tooOld;
  try {
    return createEgl();
  } catch (const TooOld& error) {
    eglSays = tooOld = error.what();
  } catch (const GpuError& error) {
    eglSays = error.what();
  }
  if (kind == ContextKind::Egl) throw GpuError(tooOld.empty() ? eglSays : nothingInstead(tooOld, {}));
  try {
    log::info(eglSays);
    auto context = createOsMesa();
    if (!tooOld.empty()) warnOfSoftware(tooOld);
    return context;
  } catch (const GpuError& error) {
    if (!tooOld.empty()) throw GpuError(nothingInstead(tooOld, error.what()));
    throw GpuError(fmt::format("no way to draw without a display: {}; {}", eglSays, error.what()));
  }
}

namespace {

class AdoptedContext : public Context {
 public:
  AdoptedContext(ProcAddress procAddress, Current current) { load(procAddress, current); }
};

}  // namespace

std::unique_ptr<Context> Context::adopt(ProcAddress procAddress, Current current) {
  return std::make_unique<AdoptedContext>(procAddress, current);
}

}  // namespace velum::gpu
