#include "gui/timeline/TrackCanvas.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QScrollBar>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "gui/kit/Text.h"
#include "gui/kit/Words.h"
#include "gui/service/CallLater.h"
#include "gui/timeline/KeyPaint.h"
#include "gui/timeline/TrackCanvasSizes.h"
#include "scene/timeline/SceneAt.h"
#include "scene/timeline/Tracks.h"
#include "session/command/Command.h"

namespace velum::gui {

TrackCanvas::TrackCanvas(session::Document& document, QWidget* parent)
    : QAbstractScrollArea(parent), mDocument(document) {
  setObjectName("trackCanvas");
  setAccessibleName(tr("Tracks of the film"));
  setToolTip(tr("Drag keys, double-click a row for a key, drag the ruler to move the playhead"));
  setFrameShape(NoFrame);
  setFocusPolicy(Qt::StrongFocus);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  viewport()->setMouseTracking(true);
  viewport()->setAutoFillBackground(false);
  connect(verticalScrollBar(), &QScrollBar::valueChanged, viewport(), qOverload<>(&QWidget::update));
  fitNow();
}

void TrackCanvas::refresh() {
  std::erase_if(mSelected, [&](const KeyName& key) { return !hasKey(tracks(), key); });
  if (mHover && !hasKey(tracks(), *mHover)) mHover.reset();
  std::erase_if(mCurves, [&](const auto& row) { return !scene::findTrack(timeline(), row.first); });
  if (!scene::findTrack(timeline(), mRow)) mRow = tracks().empty() ? std::string() : tracks().front().path;
  if (mIsFitted && mDrag == Drag::None) fitNow();
  placeBars();
  if (mDrag == Drag::None && playhead() != mFollowed) showTime(playhead());
  mFollowed = playhead();
  viewport()->update();
}

// Places.

QRectF TrackCanvas::timeArea() const {
  return {kTitleWidth, kRulerHeight, std::max(1.0, viewport()->width() - kTitleWidth),
          std::max(1.0, viewport()->height() - kRulerHeight)};
}

double TrackCanvas::yOf(std::size_t row) const {
  return kRulerHeight + (double(row) + 0.5) * kTrackHeight - verticalScrollBar()->value();
}

double TrackCanvas::rangeEnd() const {
  scene::FilmFrames frames = scene::framesOf(timeline());
  return timeline().rangeEnd > timeline().rangeStart ? std::min(timeline().rangeEnd, timeline().duration)
                                                     : std::max(frames.start, timeline().duration);
}

std::optional<QPointF> TrackCanvas::placeOf(const KeyName& key) const {
  for (std::size_t row = 0; row < tracks().size(); ++row)
    if (tracks()[row].path == key.path && scene::keyAt(tracks()[row], key.time))
      return QPointF(mScale.xOf(key.time), yOf(row));
  return std::nullopt;
}

QPointF TrackCanvas::onRuler(double time) const { return {mScale.xOf(time), 0.4 * kRulerHeight}; }
QPointF TrackCanvas::onTitle(std::size_t row) const { return {0.5 * kTitleWidth, yOf(row)}; }
QPointF TrackCanvas::onEye(std::size_t row) const { return {17.0, yOf(row)}; }

TrackCanvas::Hit TrackCanvas::hitAt(QPointF place) const {
  using Part = Hit::Part;
  if (place.y() < kRulerHeight) {
    if (place.x() < kTitleWidth - kFlagReach) return {};
    double toStart = std::abs(place.x() - mScale.xOf(timeline().rangeStart));
    double toEnd = std::abs(place.x() - mScale.xOf(rangeEnd()));
    bool isLow = place.y() > 0.6 * kRulerHeight;  // where the handles are
    auto playhead = mDocument.playhead();
    bool isPlayhead = playhead && std::abs(place.x() - mScale.xOf(*playhead)) <= kFlagReach;
    if (isLow && !isPlayhead && std::min(toStart, toEnd) <= kFlagReach)
      return {toStart < toEnd ? Part::RangeStart : Part::RangeEnd, 0, {}};
    return {Part::Ruler, 0, {}};
  }
  double down = (place.y() - kRulerHeight + verticalScrollBar()->value()) / kTrackHeight;
  auto row = std::size_t(std::max(0.0, down));
  if (row >= tracks().size()) return {};
  if (place.x() < kTitleWidth) return {place.x() < 30.0 ? Part::Eye : Part::Title, row, {}};
  const scene::Track& track = tracks()[row];
  double best = kKeyReach;
  Hit hit{Part::Row, row, {track.path, mScale.timeAt(place.x())}};
  for (const scene::Key& key : track.keys)
    if (double off = std::abs(mScale.xOf(key.time) - place.x()); off <= best)
      best = off, hit = {Part::Key, row, {track.path, key.time}};
  return hit;
}

double TrackCanvas::snapped(double time, const KeyNames& but) const {
  time = std::max(0.0, time);
  if (!mSnaps) return time;
  double best = std::round(time * timeline().framesPerSecond) / timeline().framesPerSecond;
  double reach = 5.0 / mScale.pixelsPerSecond;
  auto draw = [&](double to) {
    if (double off = std::abs(to - time); off < reach) reach = off, best = to;
  };
  if (mDrag != Drag::Playhead && mDocument.playhead()) draw(playhead());
  for (const scene::Track& track : tracks())
    for (const scene::Key& key : track.keys)
      if (std::ranges::find(but, KeyName{track.path, key.time}) == but.end()) draw(key.time);
  return best;
}

// What is seen of the time.

void TrackCanvas::fitNow() {
  double last = timeline().duration;
  for (const scene::Track& track : tracks())
    if (!track.keys.empty()) last = std::max(last, track.keys.back().time);
  mScale = fitted(0.0, last, kTitleWidth + kTrackMargin, timeArea().width() - 2.0 * kTrackMargin);
}

void TrackCanvas::fit() {
  mIsFitted = true;
  fitNow();
  viewport()->update();
}

void TrackCanvas::zoom(double factor) {
  mIsFitted = false;
  bool isSeen = timeArea().contains(QPointF(mScale.xOf(playhead()), kRulerHeight + 1));
  mScale = zoomed(mScale, isSeen ? playhead() : mScale.timeAt(timeArea().center().x()), factor);
  viewport()->update();
}

void TrackCanvas::pan(double pixels) {
  mIsFitted = false;
  double last = std::max(0.0, timeline().duration - 20.0 / mScale.pixelsPerSecond);
  mScale.start = std::clamp(mScale.start - pixels / mScale.pixelsPerSecond, 0.0, last);
  viewport()->update();
}

/// Brings a time into view.
void TrackCanvas::showTime(double time) {
  double x = mScale.xOf(time);
  if (x < mScale.left - kTrackMargin || x > timeArea().right()) {
    mScale.start = std::max(0.0, time - 0.1 * timeArea().width() / mScale.pixelsPerSecond);
    mIsFitted = false;
  }
  viewport()->update();
}

void TrackCanvas::placeBars() {
  double all = double(tracks().size()) * kTrackHeight;
  verticalScrollBar()->setRange(0, std::max(0, int(all - timeArea().height())));
  verticalScrollBar()->setPageStep(int(timeArea().height()));
  verticalScrollBar()->setSingleStep(int(kTrackHeight));
}

void TrackCanvas::resizeEvent(QResizeEvent*) {
  if (mIsFitted) fitNow();
  placeBars();
}

// The playhead.

void TrackCanvas::scrubTo(double time) {
  bool isAsked = mWanted.has_value();
  mWanted = std::clamp(time, 0.0, scene::kLongestFilm);
  if (isAsked) return;
  callLater(this, [this] {
    if (auto wanted = std::exchange(mWanted, std::nullopt); wanted && wanted != mDocument.playhead())
      mDocument.setPlayhead(*wanted);
  });
}

void TrackCanvas::goToKey(int direction) {
  double best = -1.0;
  for (const scene::Track& track : tracks())
    for (const scene::Key& key : track.keys) {
      double ahead = (key.time - playhead()) * direction;
      if (ahead > 1e-6 && (best < 0.0 || ahead < best)) best = ahead;
    }
  if (best < 0.0) return;
  double time = playhead() + best * direction;
  mDocument.setPlayhead(time);
  showTime(time);
}

// What is selected.

bool TrackCanvas::isSelected(const KeyName& key) const { return std::ranges::find(mSelected, key) != mSelected.end(); }

void TrackCanvas::select(KeyNames keys) {
  mSelected = std::move(keys);
  viewport()->update();
}

void TrackCanvas::selectRow(std::size_t row) {
  if (row < tracks().size()) mRow = tracks()[row].path;
  viewport()->update();
}

/// In the order of reading: row by row.
KeyNames TrackCanvas::allKeys() const {
  KeyNames all;
  for (const scene::Track& track : tracks())
    for (const scene::Key& key : track.keys) all.push_back({track.path, key.time});
  return all;
}

void TrackCanvas::change(const QString& step, const Tracks& changed, bool merge) {
  auto take = [&changed](scene::Scene& scene) { scene.timeline.tracks = changed; };
  session::editByHand(mDocument, step.toStdString(), take, merge);
}

QString TrackCanvas::tipOf(const Hit& hit) const {
  switch (hit.part) {
    case Hit::Part::Nothing:
      return toolTip();
    case Hit::Part::Ruler:
      return tr("Drag to move the playhead; Ctrl and the wheel show more or less time");
    case Hit::Part::RangeStart:
    case Hit::Part::RangeEnd:
      return tr("Part of the film that is played and saved: drag its ends");
    case Hit::Part::Eye:
      return tracks()[hit.row].enabled ? tr("The track counts: click to switch it off")
                                       : tr("The track is off: click to switch it on");
    case Hit::Part::Title:
    case Hit::Part::Row:
      return toText(tracks()[hit.row].path);
    case Hit::Part::Key:
      break;
  }
  const scene::Track& track = tracks()[hit.row];
  const scene::Key& key = track.keys[*scene::keyAt(track, hit.key.time)];
  return QString("%L1 s, %2: %3").arg(key.time).arg(easeName(key.ease), inSentence(easeMeaning(key.ease)));
}

bool TrackCanvas::viewportEvent(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QAbstractScrollArea::viewportEvent(event);
  const auto& help = static_cast<QHelpEvent&>(*event);
  QToolTip::showText(help.globalPos(), tipOf(hitAt(help.pos())), viewport());
  return true;
}

}  // namespace velum::gui
