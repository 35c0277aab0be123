#pragma once

namespace velum::gpu {

/// One file under shaders/, put into the program at build time.
struct ShaderFile {
  const char* path;
  const char* text;
};
extern const ShaderFile kShaderFiles[];
extern const unsigned kShaderFileCount;

}  // namespace velum::gpu
