#pragma once
#include <QObject>
#include <memory>
#include <vector>

#include "gui/service/NewestJob.h"
#include "gui/view/Viewport.h"
#include "session/Bar.h"
#include "session/Session.h"
#include "session/structure/StructureAreas.h"

namespace velum::gui {

/// Counts how much of the picture each structure takes: seen, hidden, removed. It counts in the background in a small
/// picture, while the bars are shown; and it does what the handles of the bars do: they set how far a structure stands
/// out of the cuts.
class AreaMeter : public QObject {
  Q_OBJECT
 public:
  AreaMeter(session::Session& session, Viewport& viewport, QObject* parent);

  void setOn(bool on);
  bool isOn() const { return mIsOn; }
  /// To be called after every change of the session.
  void refresh();
  bool isMeasuring() const { return mCounting.isBusy(); }
  /// The counts of a structure; null where they are not known.
  const Counts* find(int id) const;

  /// Takes hold of the handle of a structure; where there is no cut to pull it out of, told() says so. @return true
  /// when the handle is held
  bool take(int id);
  void moveTo(double pixels);
  void letGo();
  /// Lets the handle go and restores what it was before it was taken.
  void giveUp();
  bool isHeld() const { return mBar.isHeld(); }

 signals:
  void measured();
  /// What a handle has come to, in words.
  void told(const QString& words);
  /// Nothing is counted until the next change.
  void failed(const QString& why);

 private:
  struct Result {
    std::vector<render::StructureHit> hits;
    std::vector<session::StructureArea> areas;
    std::vector<int> cuts;
  };
  void measure();
  Job::Work counting(const std::shared_ptr<Result>& result) const;

  session::Session& mSession;
  Viewport& mViewport;
  bool mIsOn = false;
  NewestJob mCounting;
  scene::Scene mMeasured;  ///< the scene that mResult is of, or will be
  Result mResult;
  session::Bar mBar;
  int mHeldId = 0;  ///< the structure whose handle is held
};

}  // namespace velum::gui
