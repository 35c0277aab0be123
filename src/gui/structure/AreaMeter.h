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

/// How much of the picture each structure takes: seen, hidden, removed. Counted in the background in a small picture,
/// while somebody looks at the bars; and what their handles do: they set how far a structure stands out of the cuts.
class AreaMeter : public QObject {
  Q_OBJECT
 public:
  AreaMeter(session::Session& session, Viewport& viewport, QObject* parent);

  void setOn(bool on);
  bool isOn() const { return mIsOn; }
  /// The session has changed.
  void refresh();
  bool isMeasuring() const { return mCounting.isBusy(); }
  /// Null where nothing is known of it.
  const Counts* find(int id) const;

  /// Takes hold of the handle of a structure; says why where it cannot be. @return true where it is held
  bool take(int id);
  void moveTo(double pixels);
  void letGo();
  /// As it was before it was taken.
  void giveUp();
  bool isHeld() const { return mBar.isHeld(); }

 signals:
  void measured();
  /// What a handle has come to, in words.
  void told(const QString& words);

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
  scene::Scene mMeasured;  ///< what the result is of, or will be
  Result mResult;
  session::Bar mBar;
  int mHeldId = 0;  ///< structure of the handle that is held
};

}  // namespace velum::gui
