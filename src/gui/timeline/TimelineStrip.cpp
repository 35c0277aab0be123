#include "gui/timeline/TimelineStrip.h"

#include <fmt/format.h>

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "gui/kit/Preferences.h"
#include "gui/kit/Text.h"
#include "gui/kit/Widgets.h"
#include "session/command/Command.h"
#include "session/command/DocumentCommands.h"

namespace velum::gui {

namespace {

constexpr int kStripRow = 38, kFirstStrip = 190, kLeastStrip = 110, kStripEdge = 5;
constexpr const char* kHeightKey = "film/height";

}  // namespace

TimelineStrip::TimelineStrip(session::Document& document, QWidget* parent)
    : QFrame(parent),
      mDocument(document),
      mRow(new QWidget(this)),
      mMoves(new StripLine(kStripRow, mRow)),
      mFilm(new StripLine(kStripRow, mRow)),
      mInto(mMoves),
      mCanvas(new TrackCanvas(document, this)) {
  setObjectName("timeline");
  setFixedHeight(std::max(kLeastStrip, Preferences().value(kHeightKey, kFirstStrip).toInt()));
  setMouseTracking(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, kStripEdge, 0, 0);
  column->setSpacing(0);
  column->addWidget(mRow);
  column->addWidget(mCanvas, 1);
  mRow->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  mRow->setMinimumWidth(1);
  auto* row = new QBoxLayout(QBoxLayout::LeftToRight, mRow);
  row->setContentsMargins(8, 0, 8, 0);
  row->setSpacing(0);
  for (StripLine* part : {mMoves, mFilm}) row->addWidget(part);
  hide();
}

QToolButton* TimelineStrip::addCommand(QAction* action, int rank) {
  auto* button = new QToolButton(mInto);
  button->setObjectName("button-" + action->objectName());
  button->setDefaultAction(action);
  button->setToolButtonStyle(Qt::ToolButtonIconOnly);
  button->setIconSize({18, 18});
  button->setFocusPolicy(Qt::TabFocus);
  button->setAccessibleName(action->text().remove('&'));
  mInto->add(button, rank);
  return button;
}

QToolButton* TimelineStrip::addButton(const QString& text, const QString& name, const QString& tip, int rank) {
  auto* button = new QToolButton(mInto);
  button->setText(text);
  button->setAccessibleName(name);
  button->setToolTip(tip);
  button->setFocusPolicy(Qt::TabFocus);
  mInto->add(button, rank);
  return button;
}

NumberField* TimelineStrip::addNumber(const char* object, const QString& name, const QString& tip, int decimals,
                                      int rank) {
  auto* field = new NumberField(mInto);
  field->setObjectName(object);
  field->setAccessibleName(name);
  field->setToolTip(tip);
  field->setDecimals(decimals);
  mInto->add(field, rank);
  return field;
}

void TimelineStrip::finishRow(QMenu& films) {
  mInto->addGap(6);
  mTime = addNumber("filmTime", tr("Time"), tr("Where the playhead is, in seconds"), 2);
  mTime->setSuffix(tr(" s"));
  mTime->setRange(0.0, scene::kLongestFilm);
  connect(mTime, &NumberField::valueChanged, this, [this](double time) { mDocument.setPlayhead(time); });
  mFrame = addNumber("filmFrame", tr("Frame"), tr("Which frame is at the playhead, the first one is 0"), 0, 5);
  mFrame->setPrefix(tr("# "));
  mFrame->setRange(0.0, 1e8);
  connect(mFrame, &NumberField::valueChanged, this, [this](double frame) {
    mDocument.setPlayhead(std::min(frame / mDocument.scene().timeline.framesPerSecond, scene::kLongestFilm));
  });
  mInto->addStretch();
  mInto = mFilm;
  mInto->addStretch();
  auto* out =
      addButton(QString::fromUtf8("\u2212"), tr("Show more time"), tr("Show more time (Ctrl and the wheel)"), 5);
  connect(out, &QToolButton::clicked, this, [this] { mCanvas->zoom(0.7); });
  auto* in = addButton("+", tr("Show less time"), tr("Show less time, larger (Ctrl and the wheel)"), 5);
  connect(in, &QToolButton::clicked, this, [this] { mCanvas->zoom(1.0 / 0.7); });
  auto* fit = addButton(tr("Fit"), tr("Show the whole film"), tr("Show the whole film"), 4);
  connect(fit, &QToolButton::clicked, mCanvas, &TrackCanvas::fit);
  mInto->addGap(6);
  addFilmNumbers();
  mInto->addGap(6);
  addReadyMade(films);
  auto* save = addButton(tr("Save film..."), tr("Save film"), tr("Write the film as a video or as pictures"), 2);
  save->setObjectName("saveFilm");
  connect(save, &QToolButton::clicked, this, &TimelineStrip::saveAsked);
  tabInLayoutOrder(this);
  foldRow();
}

void TimelineStrip::foldRow() {
  bool hasRoom = mMoves->sizeHint().width() + mFilm->sizeHint().width() + 16 <= width();
  auto* row = static_cast<QBoxLayout*>(mRow->layout());
  auto direction = hasRoom ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom;
  if (row->direction() != direction) row->setDirection(direction);
}

void TimelineStrip::resizeEvent(QResizeEvent* event) {
  foldRow();
  QFrame::resizeEvent(event);
}

void TimelineStrip::addReadyMade(QMenu& films) {
  auto* button = addButton(tr("Add film"), tr("Add film"), tr("Add a film that is ready-made, to be changed then"), 1);
  button->setObjectName("addFilm");
  button->setPopupMode(QToolButton::InstantPopup);
  button->setMenu(&films);
}

void TimelineStrip::addFilmNumbers() {
  mDuration = addNumber("filmDuration", tr("Length of the film"), tr("How long the film is, in seconds"), 2);
  mDuration->setSuffix(tr(" s"));
  mDuration->setRange(0.01, scene::kLongestFilm);
  connect(mDuration, &NumberField::valueChanged, this,
          [this](double value) { setFilm("timeline.duration", value, tr("Change length of film")); });
  mRate = addNumber("filmRate", tr("Frames per second"), tr("How many pictures a second has"), 2, 3);
  mRate->setSuffix(tr(" fps"));
  mRate->setRange(0.01, 1000.0);
  connect(mRate, &NumberField::valueChanged, this,
          [this](double value) { setFilm("timeline.framesPerSecond", value, tr("Change frames per second")); });
}

void TimelineStrip::setFilm(const char* field, double value, const QString& step) {
  session::edit(mDocument, session::SetField{field, fmt::format("{}", value)}, false, step.toStdString());
}

void TimelineStrip::refresh() {
  const scene::Timeline& film = mDocument.scene().timeline;
  double time = mDocument.playhead().value_or(0.0);
  auto show = [](NumberField* field, double value) {
    const QSignalBlocker quiet(field);
    if (!field->hasFocus() || std::abs(field->value() - value) > 1e-9) field->setValue(value);
  };
  show(mTime, time);
  show(mFrame, std::round(time * film.framesPerSecond));
  show(mDuration, film.duration);
  show(mRate, film.framesPerSecond);
  mCanvas->refresh();
}

// The upper edge makes the strip higher.

void TimelineStrip::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && event->position().y() <= kStripEdge)
    mGrip = height() + event->globalPosition().y();
}

void TimelineStrip::mouseMoveEvent(QMouseEvent* event) {
  setCursor(mGrip || event->position().y() <= kStripEdge ? Qt::SizeVerCursor : Qt::ArrowCursor);
  if (!mGrip) return;
  int most = std::max(kLeastStrip, parentWidget()->height() - 260);
  setFixedHeight(std::clamp(int(*mGrip - event->globalPosition().y()), kLeastStrip, most));
}

void TimelineStrip::mouseReleaseEvent(QMouseEvent*) {
  if (mGrip) Preferences().setValue(kHeightKey, height());
  mGrip.reset();
}

}  // namespace velum::gui
