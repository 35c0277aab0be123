#pragma once
#include <cstdlib>
#include <fstream>
#include <initializer_list>
#include <string>
#include <string_view>

#include "SourceFolder.h"
#include "TempFolder.h"
#include "gpu/Program.h"

namespace velum {

/// Shaders of a test's own, which may include those of the project.
class ProbeShaders {
 public:
  ProbeShaders() {
    std::filesystem::copy(sourceFolder() / "shaders", mFolder.path(), std::filesystem::copy_options::recursive);
  }
  /// @param name  with the ending of its stage: `probe.comp`
  void add(const std::string& name, const std::string& text) const { std::ofstream(mFolder / name) << text; }
  gpu::Program make(std::initializer_list<std::string_view> names, const gpu::Defines& defines = {}) const {
    ::setenv("VELUM_SHADER_DIR", mFolder.path().c_str(), 1);
    struct Restore {
      ~Restore() { ::unsetenv("VELUM_SHADER_DIR"); }
    } restore;
    return gpu::Program(names, defines);
  }

 private:
  TempFolder mFolder;
};

}  // namespace velum
