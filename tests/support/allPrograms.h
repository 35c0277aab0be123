#pragma once
#include <string>
#include <vector>

#include "gpu/Program.h"
#include "membrane/sheet/Programs.h"
#include "model/Programs.h"
#include "render/Programs.h"

namespace velum {

/// Every program that the programs and benchmarks can ask for, as those who ask say.
inline std::vector<gpu::ProgramSource> allPrograms() {
  std::vector<gpu::ProgramSource> all = render::allPrograms();
  for (const auto& more : {membrane::allPrograms(), model::allPrograms()})
    all.insert(all.end(), more.begin(), more.end());
  all.push_back({{"bench/trilinear.comp"}, {}});
  return all;
}

inline std::string textOf(const gpu::ProgramSource& source) {
  std::string text = source.files[0];
  for (const auto& [name, value] : source.defines) text += " " + name + "=" + value;
  return text;
}

}  // namespace velum
