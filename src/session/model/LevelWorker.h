#pragma once
#include <atomic>
#include <filesystem>
#include <optional>

#include "core/Levels.h"
#include "core/Model.h"
#include "core/Shared.h"
#include "scene/SceneFwd.h"
#include "session/Worker.h"

namespace velum::session {

/// Makes the levels of detail of a model that was shown with quick ones (model::makeQuickLevels()), so that somebody
/// who opens a model sees it before they are there. Through undo the quick ones may come back: what was made is put in
/// their place at once.
class LevelWorker : public Worker {
 public:
  /// @param folder  of the cache, as of cachedLevels()
  explicit LevelWorker(std::filesystem::path folder);

  void follow(const scene::Scene& scene) override;
  Work nextWork() override;
  bool wantsCancel() const override { return mIsWorking && !(mWorkedOn == mWanted); }
  void endWork(const Finish& finish, const std::string& error) override;
  bool isOnItsWay() const override { return isDue(); }
  bool isSettled() const override { return !isDue(); }
  bool hasRests() const override { return mWanted && mWanted == mMadeOf; }
  void complete(scene::Scene& scene) override;

  /// How much of the levels is there, 0..1; nothing where none are on their way.
  std::optional<double> fractionDone() const;

 private:
  bool isDue() const { return mWanted && !(mWanted == mMadeOf) && !(mWanted == mFailedOf); }

  std::filesystem::path mFolder;
  Shared<Model> mWanted;  ///< The model whose levels are quick; none: there is no such model.
  Shared<Model> mWorkedOn, mMadeOf, mFailedOf;
  Shared<LevelSet> mMade;
  bool mIsWorking = false;
  std::atomic<double> mFraction{0.0};
};

}  // namespace velum::session
