#include "gpu/Program.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/Assert.h"
#include "core/Clock.h"
#include "core/Log.h"
#include "gpu/Gl.h"
#include "gpu/GpuError.h"
#include "gpu/ShaderLibrary.h"
#include "shared/draw.h"

namespace velum::gpu {

void deleteProgram(unsigned id) {
  if (hasGl()) gl().DeleteProgram(id);
}

namespace {

constexpr GLenum kCompletionStatus = 0x91B1;  ///< GL_COMPLETION_STATUS_KHR
constexpr double kSlowMs = 50;                ///< What takes longer to compile is worth a word.

void deleteShader(unsigned id) {
  if (hasGl()) gl().DeleteShader(id);
}
using Shader = Handle<deleteShader>;

unsigned createProgram() { return gl().CreateProgram(); }

GLenum stageOf(std::string_view file) {
  if (file.ends_with(".comp")) return GL_COMPUTE_SHADER;
  return file.ends_with(".vert") ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER;
}

/// One of a program's files, as the driver has been given it.
struct Stage {
  std::string file;
  ShaderText source;
  Shader shader;
};

Stage startStage(std::string_view file, const Defines& defines) {
  Stage stage{std::string(file), expandShader(file, defines), Shader(gl().CreateShader(stageOf(file)))};
  const char* text = stage.source.text.c_str();
  gl().ShaderSource(stage.shader.id(), 1, &text, nullptr);
  gl().CompileShader(stage.shader.id());
  return stage;
}

/// @throw GpuError where it does not compile
void checkStage(const Stage& stage) {
  GLint ok = 0;
  gl().GetShaderiv(stage.shader.id(), GL_COMPILE_STATUS, &ok);
  if (ok) return;
  std::string log(16384, '\0');
  GLsizei length = 0;
  gl().GetShaderInfoLog(stage.shader.id(), GLsizei(log.size()), &length, log.data());
  log.resize(std::size_t(length));
  throw GpuError(fmt::format("the shader {} does not compile:\n{}", stage.file, explainLog(log, stage.source)));
}

}  // namespace

struct Program::Making {
  std::vector<Stage> stages;
  Clock::time_point since = Clock::now();
};

Program::Program(std::initializer_list<std::string_view> files, const Defines& defines)
    : Handle(createProgram()), mMaking(std::make_shared<Making>()) {
  MayRefuse mayRefuse;
  for (auto file : files) {
    mMaking->stages.push_back(startStage(file, defines));
    gl().AttachShader(id(), mMaking->stages.back().shader.id());
  }
  gl().LinkProgram(id());
  gl().ObjectLabel(GL_PROGRAM, id(), GLsizei(files.begin()->size()), files.begin()->data());
  isReady();
}

bool Program::isReady() const {
  if (!mMaking) return true;
  if (!gl().compilesBeside) {
    finish();
    return true;
  }
  MayRefuse mayRefuse;
  GLint isDone = 1;
  gl().GetProgramiv(id(), kCompletionStatus, &isDone);
  if (isDone) finish();
  return isDone != 0;
}

/// Asks the driver what became of it, and waits where it is still at work. What has failed fails each time.
void Program::finish() const {
  if (!mMaking) return;
  MayRefuse mayRefuse;
  GLint ok = 0;
  gl().GetProgramiv(id(), GL_LINK_STATUS, &ok);
  const std::string& file = mMaking->stages.front().file;
  if (!ok) {
    for (const Stage& stage : mMaking->stages) checkStage(stage);
    std::string log(16384, '\0');
    GLsizei length = 0;
    gl().GetProgramInfoLog(id(), GLsizei(log.size()), &length, log.data());
    log.resize(std::size_t(length));
    throw GpuError(fmt::format("the shader {} does not link: {}", file, log));
  }
  if (double ms = msSince(mMaking->since); ms > kSlowMs)
    log::info(fmt::format("{} was compiled in {:.0f} ms", file, ms));
  mMaking.reset();
}

unsigned Program::finishedId() const {
  finish();
  return id();
}

int Program::memberOffset(const std::string& block, const std::string& member) const {
  GLuint index = gl().GetProgramResourceIndex(finishedId(), GL_UNIFORM, (block + "." + member).c_str());
  if (index == GL_INVALID_INDEX) index = gl().GetProgramResourceIndex(finishedId(), GL_UNIFORM, member.c_str());
  if (index == GL_INVALID_INDEX) return -1;
  const GLenum what = GL_OFFSET;
  GLint offset = -1;
  gl().GetProgramResourceiv(finishedId(), GL_UNIFORM, index, 1, &what, 1, nullptr, &offset);
  return offset;
}

void Program::use() const { gl().UseProgram(finishedId()); }
void Program::set(int location, int value) const { gl().ProgramUniform1i(finishedId(), location, value); }
void Program::set(int location, float v) const { gl().ProgramUniform1f(finishedId(), location, v); }
void Program::set(int location, glm::ivec2 v) const { gl().ProgramUniform2i(finishedId(), location, v.x, v.y); }
void Program::set(int location, glm::ivec4 v) const {
  gl().ProgramUniform4i(finishedId(), location, v.x, v.y, v.z, v.w);
}
void Program::set(int location, glm::vec4 v) const {
  gl().ProgramUniform4f(finishedId(), location, v.x, v.y, v.z, v.w);
}

void dispatch(const Program& program, glm::ivec3 groups) {
  VELUM_ASSERT(std::min({groups.x, groups.y, groups.z}) >= 0 && std::max({groups.x, groups.y, groups.z}) <= kMostGroups,
               "as many groups along each axis as every driver takes");
  program.use();
  gl().DispatchCompute(GLuint(groups.x), GLuint(groups.y), GLuint(groups.z));
}

void dispatchLine(const Program& program, std::uint32_t groups, int parts) {
  if (groups == 0) return;
  std::uint32_t across = std::min(groups, shared::kGroupsAcross);
  dispatch(program, {int(across), int((groups + across - 1) / across), parts});
}

void dispatchIndirect(const Program& program, const Buffer& commands, int index) {
  program.use();
  gl().BindBuffer(GL_DISPATCH_INDIRECT_BUFFER, commands.id());
  gl().DispatchComputeIndirect(GLintptr(index) * GLintptr(sizeof(shared::DispatchCommand)));
}

void barrier() { gl().MemoryBarrier(GL_ALL_BARRIER_BITS); }
void finish() { gl().Finish(); }
void flush() { gl().Flush(); }

}  // namespace velum::gpu
