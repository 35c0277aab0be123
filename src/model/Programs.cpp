#include "model/Programs.h"

#include "model/InstanceTarget.h"

namespace velum::model {

std::vector<gpu::ProgramSource> allPrograms() {
  std::vector<gpu::ProgramSource> all;
  for (const char* name : {"arguments", "pyramid", "seen", "flood", "shown"})
    all.push_back({{std::string("model/") + name + ".comp"}, {}});
  for (CullBy by : {CullBy::Cuts, CullBy::Membranes, CullBy::States, CullBy::Ghosts})
    for (bool isOfSeen : {false, true}) all.push_back({{"model/cull.comp"}, cullDefines(by, isOfSeen)});
  for (bool hasMembranes : {false, true}) {
    all.push_back({{"model/clip.comp"}, focusDefines(hasMembranes, false)});
    for (bool isOfOccluders : {false, true})
      all.push_back({{"model/focus.comp"}, focusDefines(hasMembranes, isOfOccluders)});
  }
  for (const gpu::Defines& defines : {gpu::Defines{}, gpu::Defines{{"LARGE", "1"}}})
    all.push_back({{"model/splat.comp"}, defines});
  return all;
}

}  // namespace velum::model
