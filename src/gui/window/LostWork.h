#pragma once
#include <memory>

#include "gui/service/Job.h"
#include "gui/window/FileLoads.h"
#include "gui/window/RecoveryBar.h"

namespace velum::gui {

/// Looks for the work of sessions that have died, and offers it in the recovery bar.
class LostWork : public QObject {
  Q_OBJECT
 public:
  LostWork(const WindowParts& parts, RecoveryBar& bar, FileLoads& loads);
  ~LostWork() override;

  void lookFor(const std::filesystem::path& root);
  bool isLooking() const { return mScan != nullptr; }
  /// Opens the first offered work that can be read, as a modified scene. @return false when there is none
  bool restore();

 signals:
  /// The user wants the offered work back: the open scene may have to be saved first.
  void restoreAsked();

 private:
  void askDiscard();

  const WindowParts& mParts;
  RecoveryBar& mBar;
  FileLoads& mLoads;
  std::unique_ptr<Job> mScan;
};

}  // namespace velum::gui
