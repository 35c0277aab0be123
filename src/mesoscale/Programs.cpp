#include "velum/mesoscale/Programs.h"

#include "velum/mesoscale/InstanceTarget.h"

namespace velum::mesoscale {

std::vector<gpu::ProgramSource> allPrograms() {
  std::vector<gpu::ProgramSource> all;
  for (const char* name : {"arguments", "pyramid", "seen"})
    all.push_back({{std::string("mesoscale/") + name + ".comp"}, {}});
  for (bool hasMembranes : {false, true})
    for (bool isOfSeen : {false, true}) all.push_back({{"mesoscale/cull.comp"}, cullDefines(hasMembranes, isOfSeen)});
  for (const gpu::Defines& defines : {gpu::Defines{}, gpu::Defines{{"LARGE", "1"}}})
    all.push_back({{"mesoscale/splat.comp"}, defines});
  return all;
}

}  // namespace velum::mesoscale
