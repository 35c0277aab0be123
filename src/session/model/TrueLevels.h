#pragma once
#include "core/Levels.h"
#include "core/Model.h"
#include "core/Shared.h"
#include "core/Task.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// For pictures, counts and files that last: sees to it that they are made with the levels of detail that
/// model::computeLevels() gives, although the scene on the screen may still have quick ones.
class TrueLevels {
 public:
  /// Replaces levels of a layer that are quick. Those of the model that was seen last are kept. @throw Cancelled
  void give(scene::ModelLayer& layer, Progress& progress);

 private:
  Shared<Model> mOf;
  Shared<LevelSet> mLevels;
};

}  // namespace velum::session
