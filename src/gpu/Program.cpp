#include "velum/gpu/Program.h"

#include <fmt/format.h>

#include <algorithm>

#include "Gl.h"
#include "ShaderLibrary.h"
#include "shared/draw.h"
#include "velum/core/Assert.h"
#include "velum/gpu/GpuError.h"

namespace velum::gpu {

void deleteProgram(unsigned id) {
  if (hasGl()) gl().DeleteProgram(id);
}

namespace {

void deleteShader(unsigned id) { gl().DeleteShader(id); }
using Shader = Handle<deleteShader>;

unsigned createProgram() { return gl().CreateProgram(); }

GLenum stageOf(std::string_view file) {
  if (file.ends_with(".comp")) return GL_COMPUTE_SHADER;
  return file.ends_with(".vert") ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER;
}

Shader compile(std::string_view file, const Defines& defines) {
  ShaderText source = expandShader(file, defines);
  MayRefuse mayRefuse;
  Shader shader(gl().CreateShader(stageOf(file)));
  const char* text = source.text.c_str();
  gl().ShaderSource(shader.id(), 1, &text, nullptr);
  gl().CompileShader(shader.id());
  GLint ok = 0;
  gl().GetShaderiv(shader.id(), GL_COMPILE_STATUS, &ok);
  if (ok) return shader;
  std::string log(16384, '\0');
  GLsizei length = 0;
  gl().GetShaderInfoLog(shader.id(), GLsizei(log.size()), &length, log.data());
  log.resize(std::size_t(length));
  throw GpuError(fmt::format("the shader {} does not compile:\n{}", file, explainLog(log, source)));
}

}  // namespace

Program::Program(std::initializer_list<std::string_view> files, const Defines& defines) : Handle(createProgram()) {
  std::vector<Shader> shaders;
  for (auto file : files) {
    shaders.push_back(compile(file, defines));
    gl().AttachShader(id(), shaders.back().id());
  }
  MayRefuse mayRefuse;
  gl().LinkProgram(id());
  GLint ok = 0;
  gl().GetProgramiv(id(), GL_LINK_STATUS, &ok);
  if (!ok) {
    std::string log(16384, '\0');
    GLsizei length = 0;
    gl().GetProgramInfoLog(id(), GLsizei(log.size()), &length, log.data());
    log.resize(std::size_t(length));
    throw GpuError(fmt::format("the shader {} does not link: {}", *files.begin(), log));
  }
  gl().ObjectLabel(GL_PROGRAM, id(), GLsizei(files.begin()->size()), files.begin()->data());
}

int Program::memberOffset(const std::string& block, const std::string& member) const {
  GLuint index = gl().GetProgramResourceIndex(id(), GL_UNIFORM, (block + "." + member).c_str());
  if (index == GL_INVALID_INDEX) index = gl().GetProgramResourceIndex(id(), GL_UNIFORM, member.c_str());
  if (index == GL_INVALID_INDEX) return -1;
  const GLenum what = GL_OFFSET;
  GLint offset = -1;
  gl().GetProgramResourceiv(id(), GL_UNIFORM, index, 1, &what, 1, nullptr, &offset);
  return offset;
}

void Program::use() const { gl().UseProgram(id()); }
void Program::set(int location, int value) const { gl().ProgramUniform1i(id(), location, value); }
void Program::set(int location, float v) const { gl().ProgramUniform1f(id(), location, v); }
void Program::set(int location, glm::ivec2 v) const { gl().ProgramUniform2i(id(), location, v.x, v.y); }
void Program::set(int location, glm::ivec4 v) const { gl().ProgramUniform4i(id(), location, v.x, v.y, v.z, v.w); }
void Program::set(int location, glm::vec4 v) const { gl().ProgramUniform4f(id(), location, v.x, v.y, v.z, v.w); }

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
