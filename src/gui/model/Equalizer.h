#pragma once
#include <QObject>
#include <string>
#include <vector>

#include "gui/service/JobRunner.h"
#include "gui/view/Viewport.h"
#include "session/Bar.h"
#include "session/Session.h"
#include "session/model/LiveCounts.h"

namespace velum::gui {

/// What the handles of the bars do ([VE] 7.2): they set how many instances of a type or compartment are drawn, or seen,
/// by the shares of cuts. While a handle is held, the number that is seen is estimated from the last picture; when the
/// handle is let go, pictures are drawn in the background until the number that is seen is the one asked for, or as
/// near to it as can be.
class Equalizer : public QObject {
  Q_OBJECT
 public:
  using Handle = session::Bar::Handle;

  Equalizer(session::Session& session, Viewport& viewport, JobRunner& jobs, QObject* parent);

  const session::LiveCounts& counts() const { return mCounts; }
  /// Chooses the cuts whose shares the handles set; where none of the chosen cuts is on, the handles set all cuts that
  /// are on. @param ids  of the cuts; empty: all cuts that are on
  void setCuts(std::vector<int> ids);
  std::vector<int> cuts() const;
  const std::vector<int>& chosenCuts() const { return mChosen; }

  /// Takes hold of a handle. @param path  of a type or compartment
  void take(const std::string& path, Handle handle);
  void moveTo(double count);
  void letGo();
  /// Lets the handle go and restores what it was before it was taken.
  void giveUp();
  bool isHeld() const { return mBar.isHeld(); }
  /// The type or compartment of the handle that is held, or that was held last as long as no complete picture has
  /// counted the result; else empty. heldCount() is the count that this handle has come to.
  const std::string& heldPath() const { return mHeldPath; }
  const Counts& heldCount() const { return mBar.now(); }

  /// Takes a handle, moves it to a count and lets it go.
  void set(const std::string& path, Handle handle, double count);
  /// To be called after every change: forgets the counts of a model that is hidden, no longer there, or a crowd.
  void refresh();

 signals:
  void counted();
  /// What a handle has come to, in words.
  void told(const QString& words);

 private:
  void hear(const render::InstanceBits& bits, bool isComplete);
  Counts countOf(const std::string& path) const;
  void findSeen(const session::Bar::Wish& wish);

  session::Session& mSession;
  Viewport& mViewport;
  JobRunner& mJobs;
  session::LiveCounts mCounts;
  std::vector<int> mChosen;
  session::Bar mBar;
  std::string mHeldPath;  ///< of the handle that is held, or was let go of and whose result no picture has shown yet
};

}  // namespace velum::gui
