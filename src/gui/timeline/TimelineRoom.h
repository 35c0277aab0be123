#pragma once
#include "gui/service/Player.h"
#include "gui/timeline/CameraPath.h"
#include "gui/timeline/RecordFrame.h"
#include "gui/timeline/TimelineStrip.h"
#include "gui/view/Room.h"

namespace velum::gui {

/// Films: the strip under the views with its commands, what plays, and what is seen of a film in the 3D view. While the
/// strip is shown there is a playhead, and with it all views show the film; without the strip they show the scene.
class TimelineRoom : public Room {
  Q_OBJECT
 public:
  TimelineRoom(const WindowParts& parts, TimelineStrip& strip);
  void refresh(const session::Session& session) override;

  bool isShown() const { return !mStrip.isHidden(); }
  void setShown(bool shown);
  /// There is a film to play; and it says which time step of a series is seen.
  bool hasFilm() const;
  bool hasTimeSteps() const;
  void setPlaying(bool playing) { mParts.player.setPlaying(mFilm, playing); }
  bool isPlaying() const { return mParts.player.isPlaying(mFilm); }
  /// What the commands for the next time step and the one before do, while the strip is shown.
  void goToKey(int direction) { mStrip.canvas().goToKey(direction); }
  const CameraPath& cameraPath() const { return mPath; }

 signals:
  /// As of TimelineStrip.
  void saveAsked();

 private:
  void addCommands();
  void addSwitches(QMenu* menu);
  void keyCamera();
  void setRecording(bool recording);
  void showWhereItIsDue();
  void tellRecorded();
  void showMenu(const render::Pick& pick, QPoint place);

  TimelineStrip& mStrip;
  Playable mFilm;
  CameraPath mPath;
  RecordFrame* mFrame;
  QAction *mShow = nullptr, *mRecord = nullptr, *mLoop = nullptr, *mSnap = nullptr, *mKeyCamera = nullptr;
  bool mHadTracks = false;
  std::string mName;                               ///< of what is open
  double mPlace = 0.0;                             ///< of the playhead when the strip was hidden, seconds
  std::optional<std::vector<scene::Track>> mSeen;  ///< while recording: the tracks at the last refresh
};

}  // namespace velum::gui
