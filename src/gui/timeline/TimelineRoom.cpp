#include "gui/timeline/TimelineRoom.h"

#include <QMainWindow>
#include <QMenu>
#include <QStatusBar>

#include "gui/kit/Icons.h"
#include "gui/kit/Preferences.h"
#include "gui/kit/Text.h"
#include "gui/kit/Words.h"
#include "gui/service/CallLater.h"
#include "scene/timeline/SceneAt.h"
#include "scene/timeline/Tracks.h"
#include "session/command/FilmCommands.h"

namespace velum::gui {

namespace {

constexpr const char *kLoopKey = "film/loop", *kSnapKey = "film/snap";
constexpr int kRecordedMs = 6000;

/// The film of a scene, played by its playhead.
Playable filmOf(session::Document& document) {
  Playable film;
  film.frames = [&document] {
    const scene::Timeline& timeline = document.scene().timeline;
    return document.playhead() && !timeline.tracks.empty() ? scene::framesOf(timeline) : scene::FilmFrames{};
  };
  film.now = [&document] { return document.playhead().value_or(0.0); };
  film.show = [&document](double time) { document.setPlayhead(time); };
  return film;
}

}  // namespace

TimelineRoom::TimelineRoom(const WindowParts& parts, TimelineStrip& strip)
    : Room(parts),
      mStrip(strip),
      mFilm(filmOf(parts.document())),
      mPath(parts.document(), parts.toolbox, [this] { return isShown(); }),
      mFrame(new RecordFrame(parts.views.viewport())) {
  addCommands();
  parts.toolbox.add(mPath);
  connect(&strip, &TimelineStrip::saveAsked, this, &TimelineRoom::saveAsked);
  connect(&parts.views.viewport(), &Viewport::menuAskedAt, this, &TimelineRoom::showMenu);
}

// Commands.

void TimelineRoom::addCommands() {
  ActionTable& actions = mParts.actions;
  QMenu* menu = mParts.menu(MenuId::Time);
  menu->addSeparator();
  mShow = actions.addForScene(menu, "film.timeline", tr("&Timeline"), tr("Show the film, with its tracks and keys"),
                              [this] { setShown(!isShown()); });
  mShow->setCheckable(true);
  QAction* start =
      actions.addForScene(menu, "film.start", tr("To the &beginning"), tr("Go to where the film begins"), [this] {
        setShown(true);
        mParts.document().setPlayhead(scene::framesOf(mParts.document().scene().timeline).start);
      });
  QAction* back = actions.addForScene(menu, "film.previousKey", tr("Key be&fore"), tr("Go to the key before"),
                                      [this] { goToKey(-1); });
  QAction* forth =
      actions.addForScene(menu, "film.nextKey", tr("Next &key"), tr("Go to the next key"), [this] { goToKey(1); });
  mStrip.addCommand(start, 3);
  mStrip.addCommand(back, 4);
  mStrip.addCommand(actions.find("time.play"));
  mStrip.addCommand(forth, 4);
  addSwitches(menu);
  mStrip.addCommand(mRecord)->setProperty("role", "record");
  mStrip.addCommand(mKeyCamera, 2);
  mStrip.addCommand(mLoop, 6);
  mStrip.addCommand(mSnap, 7);
  mStrip.finishRow(*mParts.menu(MenuId::Film));
}

void TimelineRoom::addSwitches(QMenu* menu) {
  ActionTable& actions = mParts.actions;
  mRecord =
      actions.addForScene(menu, "film.record", tr("&Record"), tr("Make keys of whatever is changed at the playhead"),
                          [this] { setRecording(mRecord->isChecked()); });
  mKeyCamera = actions.addForScene(menu, "film.keyCamera", tr("Key &camera"),
                                   tr("Make a key of where the eye is, at the playhead"), [this] { keyCamera(); });
  mLoop = actions.addForScene(menu, "film.loop", tr("&Loop"), tr("Play the film again and again"), [this] {
    mFilm.loops = mLoop->isChecked();
    Preferences().setValue(kLoopKey, mLoop->isChecked());
  });
  mSnap = actions.addForScene(menu, "film.snap", tr("Sn&ap"), tr("Keys and playhead go to frames, and to each other"),
                              [this] {
                                mStrip.canvas().setSnapping(mSnap->isChecked());
                                Preferences().setValue(kSnapKey, mSnap->isChecked());
                              });
  mRecord->setIcon(makeIcon("film.record", kRecordRed));
  for (QAction* action : {mRecord, mLoop, mSnap}) action->setCheckable(true);
  mLoop->setChecked(Preferences().value(kLoopKey, false).toBool());
  mSnap->setChecked(Preferences().value(kSnapKey, true).toBool());
  mFilm.loops = mLoop->isChecked();
  mStrip.canvas().setSnapping(mSnap->isChecked());
}

void TimelineRoom::setShown(bool shown) {
  session::Document& document = mParts.document();
  if (!shown && mStrip.canvas().hasFocus()) mParts.views.viewport().setFocus();
  mStrip.setVisible(shown);
  if (!shown) {
    setPlaying(false);
    mPlace = document.playhead().value_or(0.0);
    document.setPlayhead(std::nullopt);
    document.setRecording(false);
  } else if (!document.playhead()) {
    document.setPlayhead(std::min(mPlace, document.scene().timeline.duration));
  }
  mShow->setChecked(shown);
}

bool TimelineRoom::hasFilm() const { return isShown() && !mParts.session.document().scene().timeline.tracks.empty(); }

bool TimelineRoom::hasTimeSteps() const {
  const scene::Track* track = scene::findTrack(mParts.session.document().scene().timeline, "volume.timeStep");
  return isShown() && track && track->enabled;
}

void TimelineRoom::keyCamera() {
  setShown(true);
  session::editKey(mParts.document(), session::SetFilmKey{"camera", -1.0, {}});
}

void TimelineRoom::setRecording(bool recording) {
  if (recording) setShown(true);
  mParts.document().setRecording(recording);
}

void TimelineRoom::showMenu(const render::Pick& pick, QPoint place) {
  if (pick.hit && (pick.structure != 0 || pick.type >= 0)) return;  // they have menus of their own
  QMenu menu(&mParts.window);
  menu.addAction(mKeyCamera);
  menu.addAction(mShow);
  menu.exec(place);
}

// What is shown.

/// The strip comes by itself with the first track, and goes with the playhead, or with what was open.
void TimelineRoom::showWhereItIsDue() {
  const session::Document& document = mParts.document();
  const session::WorkFile& file = mParts.session.file();
  bool hasHistory = document.canUndo() || document.canRedo();
  bool isOther = !hasHistory && (file.path() != mName || (isShown() && !document.playhead()));
  if (isOther) mName = file.path(), mPlace = 0.0, mHadTracks = false;
  bool hasTracks = file.isOpen() && !document.scene().timeline.tracks.empty();
  bool isDue = file.isOpen() && (document.playhead() || (hasTracks && !mHadTracks));
  mHadTracks = hasTracks;
  if (isDue == isShown() && isDue == document.playhead().has_value()) return;
  callLater(this, [this, isDue] { setShown(isDue && mParts.session.file().isOpen()); });
}

/// Says, while recording, of which fields keys were made since the last time.
void TimelineRoom::tellRecorded() {
  if (!mParts.document().isRecording()) return mSeen.reset();
  const auto& tracks = mParts.document().scene().timeline.tracks;
  if (!mSeen) mSeen = tracks;
  QStringList titles;
  for (const scene::Track& track : tracks) {
    auto before = std::ranges::find(*mSeen, track.path, &scene::Track::path);
    if (before == mSeen->end() || !(before->keys == track.keys))
      titles << wordsOf(scene::trackTitle(mParts.document().scene(), track.path));
  }
  mSeen = tracks;
  auto* window = qobject_cast<QMainWindow*>(&mParts.window);
  if (!titles.isEmpty() && window)
    window->statusBar()->showMessage(
        tr("Recorded at %L1 s: %2").arg(mParts.document().playhead().value_or(0.0)).arg(titles.join(", ")),
        kRecordedMs);
}

void TimelineRoom::refresh(const session::Session& session) {
  showWhereItIsDue();
  bool isRecording = session.document().isRecording();
  mRecord->setChecked(isRecording);
  mFrame->setVisible(isRecording);
  if (isRecording) mFrame->raise();
  tellRecorded();
  for (const char* id : {"film.previousKey", "film.nextKey"})
    mParts.actions.find(id)->setEnabled(isShown() && !session.document().scene().timeline.tracks.empty());
  if (isShown()) mStrip.refresh();
}

}  // namespace velum::gui
