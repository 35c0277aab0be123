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

/// What a program is made of, for lists of them.
struct ProgramSource {
  std::vector<std::string> files;  ///< one .comp, or a .vert and a .frag, under shaders/
  Defines defines;
};

/// A program from entry points under shaders/ (`render/ray_cast.comp`). Many drivers compile it beside this thread, as
/// it may take seconds: whoever uses it before isReady() waits. Compile errors name file and line of the included text.
/// GL thread. @throw GpuError with the driver's message, `file:line: text`, when it is made or, from drivers that
/// compile beside, by isReady() and whenever it is used
class Program : public Handle<deleteProgram> {
 public:
  Program() = default;
  /// @param files  one .comp, or a .vert and a .frag
  Program(std::initializer_list<std::string_view> files, const Defines& defines = {});
  /// Nobody waits who uses it now.
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
  mutable std::shared_ptr<Making> mMaking;  ///< Until the driver has said what became of it.
};

/// As many groups along an axis as every driver takes (OpenGL 4.5, table 23.75). Most take more along some axis: what
/// works by that fails on another.
inline constexpr int kMostGroups = 65535;

/// Runs a compute program. Group counts, not threads, each up to kMostGroups. Every dispatch comes through here.
void dispatch(const Program& program, glm::ivec3 groups);
/// Runs groups that are numbered one after the other, however many: they lie in rows, and the shader asks
/// shaders/common/line.glsl for their numbers. @param parts  groups of each number, gl_WorkGroupID.z
void dispatchLine(const Program& program, std::uint32_t groups, int parts = 1);
/// Runs it for as many groups as shared::DispatchCommand `index` of a buffer says when the GPU comes to it: for work
/// whose amount a shader finds out. After gpu::barrier() where a shader wrote the command.
void dispatchIndirect(const Program& program, const Buffer& commands, int index = 0);
/// What shaders have written becomes visible to later reads of any kind.
void barrier();
/// Hands the commands over and waits until they are done.
void finish();
/// Hands the commands over.
void flush();

/// Every entry point under shaders/, for the test that compiles them all.
std::vector<std::string> shaderEntryPoints();
/// The text of an entry point with its includes, as the driver sees it; for tests. @throw GpuError
std::string expandedShader(std::string_view file, const Defines& defines = {});

}  // namespace velum::gpu
