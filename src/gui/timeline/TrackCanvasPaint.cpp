// How the tracks of a film look.
#include "gui/timeline/TrackCanvas.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "core/Text.h"
#include "gui/kit/CurveCanvas.h"
#include "gui/kit/Text.h"
#include "gui/kit/Theme.h"
#include "gui/kit/Words.h"
#include "gui/timeline/KeyPaint.h"
#include "gui/timeline/RecordFrame.h"
#include "gui/timeline/TrackCanvasSizes.h"
#include "scene/timeline/SceneAt.h"
#include "scene/timeline/Tracks.h"

namespace velum::gui {

namespace {

constexpr int kCurvePoints = 96;
constexpr double kNumberRoom = 58.0;  ///< pixels from a number of the ruler to the next

/// A number at each of some moments of a film, as shares of the height between its least and its most; empty for what
/// is no number, or always the same.
std::vector<double> heightsOf(const scene::Scene& scene, const scene::Track& track, double duration) {
  scene::Scene alone = scene;
  alone.timeline.tracks = {track};
  alone.timeline.tracks[0].enabled = true;
  std::vector<double> numbers;
  for (int i = 0; i <= kCurvePoints; ++i) {
    double time = duration * i / kCurvePoints;
    if (track.path == scene::kOrbitPath) {
      numbers.push_back(scene::orbitAt(alone, time));
      continue;
    }
    auto number = numberIn(scene::valueAt(scene::sceneAt(alone, time), track.path).json);
    if (!number) return {};
    numbers.push_back(*number);
  }
  auto [least, most] = std::ranges::minmax(numbers);
  if (!(most > least)) return {};
  for (double& number : numbers) number = (number - least) / (most - least);
  return numbers;
}

}  // namespace

void TrackCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(viewport());
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(viewport()->rect(), palette().color(QPalette::Window));
  painter.fillRect(timeArea(), palette().color(QPalette::Base));
  paintRange(painter);
  painter.save();
  painter.setClipRect(QRectF(0, kRulerHeight, viewport()->width(), timeArea().height()));
  for (std::size_t row = 0; row < tracks().size(); ++row) {
    if (yOf(row) < kRulerHeight - kTrackHeight || yOf(row) > viewport()->height() + kTrackHeight) continue;
    paintTitle(painter, row);
    paintTrack(painter, row);
  }
  painter.restore();
  if (tracks().empty()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(
        timeArea().adjusted(12, 0, -12, 0), Qt::AlignCenter | Qt::TextWordWrap,
        tr("Nothing changes yet. Record while you change things, choose Key this in the menu of a control, "
           "or add a film that is ready-made."));
  }
  paintRuler(painter);
  paintFlags(painter);
  paintPlayhead(painter);
  if (mDrag == Drag::Band && !mBand.isEmpty()) {
    painter.setPen(palette().color(QPalette::Link));
    painter.setBrush(faded(palette().color(QPalette::Link), 0.15));
    painter.drawRect(mBand);
  }
  if (!hasFocus()) return;
  painter.setPen(QPen(faded(palette().color(QPalette::Link), 0.7), 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(QRectF(viewport()->rect()).adjusted(0.5, 0.5, -0.5, -0.5));
}

void TrackCanvas::paintRuler(QPainter& painter) const {
  painter.save();
  QRectF ruler(kTitleWidth, 0, timeArea().width(), kRulerHeight);
  painter.setClipRect(ruler);
  painter.setFont(smallFont(font()));
  QFontMetricsF metrics(painter.font());
  double step = rulerStep(mScale, kNumberRoom, timeline().framesPerSecond);
  double last = std::min(mScale.timeAt(ruler.right()), scene::kLongestFilm);
  auto first = qint64(std::floor(mScale.start / step));
  for (qint64 i = std::max<qint64>(first, 0); double(i) * step <= last; ++i) {
    double time = double(i) * step, x = std::round(mScale.xOf(time)) + 0.5;
    bool isIn = time <= timeline().duration + 1e-9;
    painter.setPen(palette().color(QPalette::Dark));
    painter.drawLine(QPointF(x, kRulerHeight - 7), QPointF(x, kRulerHeight));
    for (int part = 1; part < 5; ++part) {
      double between = std::round(mScale.xOf(time + step * part / 5.0)) + 0.5;
      painter.drawLine(QPointF(between, kRulerHeight - 3), QPointF(between, kRulerHeight));
    }
    painter.setPen(palette().color(isIn ? QPalette::WindowText : QPalette::PlaceholderText));
    QString text = rulerText(time, step);
    if (i == 0) text += tr(" s");
    double left = std::max(ruler.left() + 2.0, x - 0.5 * metrics.horizontalAdvance(i == 0 ? "0" : text));
    painter.drawText(QPointF(left, 12.0), text);
  }
  painter.restore();
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawLine(QPointF(0, kRulerHeight - 0.5), QPointF(viewport()->width(), kRulerHeight - 0.5));
  painter.drawLine(QPointF(kTitleWidth - 0.5, 0), QPointF(kTitleWidth - 0.5, viewport()->height()));
}

/// What is not played is dimmed.
void TrackCanvas::paintRange(QPainter& painter) const {
  QRectF area = timeArea();
  double from = mScale.xOf(timeline().rangeStart), to = mScale.xOf(rangeEnd());
  QColor shade = faded(palette().color(QPalette::Window), 0.62);
  painter.save();
  painter.setClipRect(QRectF(kTitleWidth, 0, area.width(), viewport()->height()));
  painter.fillRect(QRectF(QPointF(area.left(), kRulerHeight), QPointF(from, area.bottom())), shade);
  painter.fillRect(QRectF(QPointF(to, kRulerHeight), QPointF(area.right(), area.bottom())), shade);
  painter.restore();
}

/// The ends of the range, which can be dragged.
void TrackCanvas::paintFlags(QPainter& painter) const {
  double from = mScale.xOf(timeline().rangeStart), to = mScale.xOf(rangeEnd());
  painter.save();
  painter.setClipRect(QRectF(kTitleWidth, 0, timeArea().width(), kRulerHeight));
  QColor accent = palette().color(QPalette::Link);
  painter.fillRect(QRectF(from, kRulerHeight - 4.0, to - from, 3.0), faded(accent, 0.55));
  painter.setPen(Qt::NoPen);
  painter.setBrush(accent);
  for (double sign : {1.0, -1.0}) {
    double x = sign > 0 ? from : to;
    QPolygonF flag{{x, kRulerHeight - 11.0}, {x + sign * 6.0, kRulerHeight - 1.0}, {x, kRulerHeight - 1.0}};
    painter.drawPolygon(flag);
  }
  painter.restore();
}

void TrackCanvas::paintTitle(QPainter& painter, std::size_t row) const {
  const scene::Track& track = tracks()[row];
  QRectF line(0, yOf(row) - 0.5 * kTrackHeight, kTitleWidth, kTrackHeight);
  if (track.path == mRow) painter.fillRect(line, palette().color(QPalette::Light));
  QPointF eye = onEye(row);
  QColor text = palette().color(track.enabled ? QPalette::WindowText : QPalette::PlaceholderText);
  painter.setPen(QPen(text, 1.2));
  painter.setBrush(Qt::NoBrush);
  QPainterPath lids(eye - QPointF(6.5, 0));
  lids.quadTo(eye - QPointF(0, track.enabled ? 8.0 : -7.0), eye + QPointF(6.5, 0));
  if (track.enabled) lids.quadTo(eye + QPointF(0, 8.0), eye - QPointF(6.5, 0));
  painter.drawPath(lids);
  if (track.enabled) {
    painter.setBrush(text);
    painter.drawEllipse(eye, 1.8, 1.8);
  }
  QRectF room = line.adjusted(32, 0, -8, 0);
  QString title = wordsOf(scene::trackTitle(mDocument.scene(), track.path));
  painter.setPen(text);
  painter.drawText(room, Qt::AlignVCenter | Qt::AlignLeft,
                   QFontMetricsF(painter.font()).elidedText(title, Qt::ElideMiddle, room.width()));
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawLine(line.bottomLeft(), QPointF(viewport()->width(), line.bottom()));
}

/// The curve is of a copy of the scene with this track alone, so that it is what the film shows.
const std::vector<double>& TrackCanvas::curveOf(const scene::Track& track) {
  Curve& curve = mCurves[track.path];
  if (curve.track == track && curve.duration == timeline().duration) return curve.heights;
  static const std::vector<double> kNone;
  if (mDrag == Drag::Keys) return kNone;  // it comes when the hand lets go
  curve = {track, timeline().duration, {}};
  bool isNumber = track.keys.size() > 1 && numberIn(track.keys.front().value.json).has_value();
  if (isNumber) curve.heights = heightsOf(mDocument.scene(), track, curve.duration);
  return curve.heights;
}

/// What is between the keys: nothing where nothing changes, else a bar, dashed where it is held.
void TrackCanvas::paintWay(QPainter& painter, const scene::Track& track, double y) {
  QColor accent = palette().color(QPalette::Link), quiet = palette().color(QPalette::Dark);
  for (std::size_t i = 0; i + 1 < track.keys.size(); ++i) {
    const scene::Key &key = track.keys[i], &next = track.keys[i + 1];
    bool isStill = key.value == next.value, isHeld = key.ease == scene::Ease::Hold;
    painter.setPen(QPen(isStill ? quiet : faded(accent, 0.75), isStill ? 1.0 : 2.0,
                        isHeld && !isStill ? Qt::DotLine : Qt::SolidLine));
    painter.drawLine(QPointF(mScale.xOf(key.time), y), QPointF(mScale.xOf(next.time), y));
  }
  const std::vector<double>& heights = curveOf(track);
  if (heights.empty()) return;
  QPainterPath curve;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    QPointF place(mScale.xOf(timeline().duration * double(i) / kCurvePoints),
                  y + (0.5 - heights[i]) * (kTrackHeight - 6.0));
    i == 0 ? curve.moveTo(place) : curve.lineTo(place);
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(faded(palette().color(QPalette::WindowText), 0.45), 1.1));
  painter.drawPath(curve);
}

void TrackCanvas::paintTrack(QPainter& painter, std::size_t row) {
  const scene::Track& track = tracks()[row];
  double y = yOf(row);
  painter.save();
  painter.setClipRect(timeArea(), Qt::IntersectClip);
  if (!track.enabled) painter.setOpacity(0.4);
  paintWay(painter, track, y);
  for (const scene::Key& key : track.keys) {
    KeyName name{track.path, key.time};
    bool isChosen = isSelected(name), isHot = mHover == name;
    painter.save();
    painter.translate(mScale.xOf(key.time), y);
    painter.setPen(QPen(palette().color(QPalette::Base), 3.0));
    painter.setBrush(Qt::NoBrush);
    QPainterPath shape = keyShape(key.ease, isHot ? kKeyRadius + 1.0 : kKeyRadius);
    painter.drawPath(shape);
    painter.setPen(QPen(palette().color(QPalette::WindowText), isChosen ? 1.6 : 1.1));
    painter.setBrush(isChosen ? QBrush(kHandle) : palette().brush(isHot ? QPalette::Link : QPalette::PlaceholderText));
    painter.drawPath(shape);
    painter.restore();
  }
  painter.restore();
}

void TrackCanvas::paintPlayhead(QPainter& painter) const {
  if (!mDocument.playhead()) return;
  double x = mScale.xOf(playhead());
  if (x < kTitleWidth - 6.0 || x > viewport()->width() + 6.0) return;
  QColor color = mDocument.isRecording() ? kRecordRed : palette().color(QPalette::WindowText);
  painter.setPen(QPen(color, 1.4));
  painter.drawLine(QPointF(x, kRulerHeight - 8.0), QPointF(x, viewport()->height()));
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  double top = kRulerHeight - 14.0;
  painter.drawPolygon(
      QPolygonF{{x - 5.5, top}, {x + 5.5, top}, {x + 5.5, top + 5.0}, {x, top + 11.0}, {x - 5.5, top + 5.0}});
}

}  // namespace velum::gui
