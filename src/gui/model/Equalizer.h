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
/// by the shares of cuts. What is seen while a handle is held is as many as the last picture lets expect; when it is
/// let go pictures are drawn beside the window until it is so many, or the nearest there is.
class Equalizer : public QObject {
  Q_OBJECT
 public:
  using Handle = session::Bar::Handle;

  Equalizer(session::Session& session, Viewport& viewport, JobRunner& jobs, QObject* parent);

  const session::LiveCounts& counts() const { return mCounts; }
  /// The cuts that are set; those that are on where none of these is. @param ids  none: all that are on
  void setCuts(std::vector<int> ids);
  std::vector<int> cuts() const;
  const std::vector<int>& chosenCuts() const { return mChosen; }

  /// Takes hold of a handle. @param path  of a type or compartment
  void take(const std::string& path, Handle handle);
  void moveTo(double count);
  void letGo();
  /// As it was before it was taken.
  void giveUp();
  bool isHeld() const { return mBar.isHeld(); }
  /// Whose, and what it has come to: until a complete picture tells it, of the last that was; else empty.
  const std::string& heldPath() const { return mHeldPath; }
  const Counts& heldCount() const { return mBar.now(); }

  /// In one go.
  void set(const std::string& path, Handle handle, double count);
  /// Forgets counts of a model that is no longer there.
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
  std::string mHeldPath;  ///< of the handle that is held, or was let go and that no picture knows of yet
};

}  // namespace velum::gui
