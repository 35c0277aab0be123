#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gpu/Buffer.h"
#include "gpu/Handle.h"

namespace velum::gpu {

void deleteProgram(unsigned id);

/// Words that a shader is compiled with: {"MODE", "2"} becomes `#define MODE 2`.
using Defines = std::vector<std::pair<std::string, std::string>>;

/// The files and defines that a program is made of, for lists of programs.
struct ProgramSource {
  std::vector<std::string> files;  ///< one .comp, or a .vert and a .frag, under shaders/
  Defines defines;
};

/// A program from entry points under shaders/ (`render/ray_cast.comp`). Many drivers compile the program on threads of
/// their own, as that may take seconds: whoever uses the program before isReady() waits. Compile errors name file and
/// line of the included text. GL thread. @throw GpuError with the driver's message, `file:line: text`: by the
/// constructor or, with drivers that compile on threads of their own, by isReady() and by every use of the program
class Program : public Handle<deleteProgram> {
 public:
  Program() = default;
  /// @param files  one .comp, or a .vert and a .frag
  Program(std::initializer_list<std::string_view> files, const Defines& defines = {});
  /// True when the program is compiled: whoever uses it now does not wait.
  bool isReady() const;
  /// Offset of a uniform block's member in bytes, -1 when there is none; for the layout tests.
  int memberOffset(const std::string& block, const std::string& member) const;
  void use() const;
  void set(int location, int value) const;
  void set(int location, float value) const;
  void set(int location, glm::ivec2 value) const;
  void set(int location, glm::ivec4 value) const;
  void set(int location, glm::vec4 value) const;

 private:
  struct Making;
  void finish() const;
  unsigned finishedId() const;
  mutable std::shared_ptr<Making> mMaking;  ///< Kept until the driver has said whether the program compiled.
};

/// The number of groups along an axis that every driver takes (OpenGL 4.5, table 23.75). Most drivers take more along
/// some axis; code that relies on that fails on other drivers.
inline constexpr int kMostGroups = 65535;

/// Runs a compute program. @p groups counts work groups, not threads; up to kMostGroups along each axis. Every dispatch
/// of the program is made by this function.
void dispatch(const Program& program, glm::ivec3 groups);
/// Runs any number of groups, numbered one after the other: they are laid out in rows, and the shader gets its group's
/// number from shaders/common/line.glsl. @param parts  how many groups have the same number; gl_WorkGroupID.z tells
/// them apart
void dispatchLine(const Program& program, std::uint32_t groups, int parts = 1);
/// Runs a compute program for as many groups as the shared::DispatchCommand number `index` in a buffer says at the time
/// when the GPU reaches it: for work whose amount a shader finds out. After gpu::barrier() where a shader wrote the
/// command.
void dispatchIndirect(const Program& program, const Buffer& commands, int index = 0);
/// Makes everything that shaders have written visible to later reads of any kind.
void barrier();
/// Hands all commands given so far over to the GPU and waits until they are done.
void finish();
/// Hands all commands given so far over to the GPU.
void flush();

/// Every entry point under shaders/, for the test that compiles them all.
std::vector<std::string> shaderEntryPoints();
/// The text of an entry point with its includes, as the driver sees it; for tests. @throw GpuError
std::string expandedShader(std::string_view file, const Defines& defines = {});

}  // namespace velum::gpu
