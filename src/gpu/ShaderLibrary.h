#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gpu/Program.h"

namespace velum::gpu {

/// An entry point with its includes in place, and where each line came from.
struct ShaderText {
  std::string text;
  std::vector<std::pair<std::string, int>> origin;  ///< (file, line) of each line of `text`.
};

/// Reads a shader from VELUM_SHADER_DIR when that is set, else from the program itself, and puts its includes in place:
/// `#include "..."` only, relative to shaders/, each file once. @throw GpuError when a file is missing
ShaderText expandShader(std::string_view file, const Defines& defines);

/// The driver's log with `0:12(3)` and the like replaced by `file:line`.
std::string explainLog(const std::string& driverLog, const ShaderText& shader);

}  // namespace velum::gpu
