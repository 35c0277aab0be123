#include "session/model/LevelWorker.h"

#include <utility>

#include "model/Levels.h"
#include "scene/Scene.h"
#include "session/model/LevelCache.h"

namespace velum::session {

LevelWorker::LevelWorker(std::filesystem::path folder) : mFolder(std::move(folder)) {}

void LevelWorker::follow(const scene::Scene& scene) {
  const scene::ModelLayer& layer = scene.model;
  bool isQuick = layer.data && layer.levels && model::areQuick(*layer.levels);
  mWanted = isQuick ? layer.data : Shared<Model>();
}

Worker::Work LevelWorker::nextWork() {
  if (mIsWorking || !isDue()) return {};
  mIsWorking = true;
  mWorkedOn = mWanted;
  mFraction = 0.0;
  return [this, model = mWanted](Progress& progress) -> Finish {
    Progress told([&](double fraction, const std::string&) {
      progress.throwIfCancelled();
      mFraction = fraction;
    });
    Shared<LevelSet> made(cachedLevels(*model, mFolder, told));
    return [this, model, made] {
      mMadeOf = model;
      mMade = made;
    };
  };
}

void LevelWorker::endWork(const Finish& finish, const std::string& error) {
  mIsWorking = false;
  if (finish)
    finish();
  else if (!error.empty())
    mFailedOf = mWorkedOn;  // a model that is too large for this machine's memory stays as it is
}

void LevelWorker::complete(scene::Scene& scene) { scene.model.levels = mMade; }

std::optional<double> LevelWorker::fractionDone() const {
  return isDue() ? std::optional(mFraction.load()) : std::nullopt;
}

}  // namespace velum::session
