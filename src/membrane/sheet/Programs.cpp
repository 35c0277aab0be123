#include "membrane/sheet/Programs.h"

namespace velum::membrane {

std::vector<gpu::ProgramSource> allPrograms() {
  std::vector<gpu::ProgramSource> all;
  for (const char* stage : {"normals", "count", "scan", "fill", "cells"})
    all.push_back({{std::string("membrane/sheet_") + stage + ".comp"}, {}});
  for (const char* stage : {"predict", "constrain", "finish"})
    for (const char* along : {"0", "1"})
      all.push_back({{std::string("membrane/") + stage + ".comp"}, {{"ALONG", along}}});
  return all;
}

}  // namespace velum::membrane
