#include "session/model/TrueLevels.h"

#include "model/Levels.h"
#include "scene/ModelLayer.h"

namespace velum::session {

void TrueLevels::give(scene::ModelLayer& layer, Progress& progress) {
  if (!layer.data || !layer.levels || !model::areQuick(*layer.levels)) return;
  if (!(mOf == layer.data)) {
    mLevels = Shared<LevelSet>(model::computeLevels(*layer.data, progress));
    mOf = layer.data;
  }
  layer.levels = mLevels;
}

}  // namespace velum::session
