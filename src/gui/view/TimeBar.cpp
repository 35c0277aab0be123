#include "gui/view/TimeBar.h"

#include <QHBoxLayout>
#include <QSignalBlocker>

#include "session/lettering/TimeStamp.h"

namespace velum::gui {

namespace {
constexpr int kStepMs = 100;  // ten steps a second, where the views keep up
}

TimeBar::TimeBar(session::Document& document, QWidget* parent)
    : QFrame(parent),
      mDocument(document),
      mPlay(new QPushButton(tr("Play"), this)),
      mSlider(new QSlider(Qt::Horizontal, this)),
      mText(new QLabel(this)) {
  setObjectName("timeBar");
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(14, 5, 14, 5);
  layout->setSpacing(12);
  mPlay->setCheckable(true);
  mPlay->setFixedWidth(74);
  mPlay->setToolTip(tr("Play the time steps round and round (Space)"));
  mSlider->setToolTip(tr("Time step"));
  mSlider->setAccessibleName(tr("Time step"));
  mSlider->setObjectName("timeSlider");
  mText->setMinimumWidth(150);
  layout->addWidget(mPlay);
  layout->addWidget(mSlider, 1);
  layout->addWidget(mText);
  mTimer.setInterval(kStepMs);
  connect(mPlay, &QPushButton::toggled, this, &TimeBar::setPlaying);
  connect(mSlider, &QSlider::valueChanged, this, [this](int timeStep) {
    mDocument.view([timeStep](scene::Scene& scene) { scene.volume.timeStep = timeStep; });
  });
  connect(&mTimer, &QTimer::timeout, this, [this] {
    bool ready = true;
    emit askReady(ready);
    if (ready) step(1);
  });
  hide();
}

int TimeBar::timeSteps() const {
  const auto& volume = mDocument.shown().volume.data;
  return volume ? volume->timeSteps : 0;
}

void TimeBar::setPlaying(bool playing) {
  playing = playing && timeSteps() > 1;
  if (playing == mTimer.isActive()) return;
  if (playing)
    mTimer.start();
  else
    mTimer.stop();
  const QSignalBlocker quiet(mPlay);
  mPlay->setChecked(playing);
  mPlay->setText(playing ? tr("Pause") : tr("Play"));
}

void TimeBar::step(int steps) {
  int count = timeSteps();
  if (count < 2) return;
  int next = ((mDocument.shown().volume.timeStep + steps) % count + count) % count;
  auto change = [next](scene::Scene& scene) { scene.volume.timeStep = next; };
  // What plays goes on by itself: there is nothing to undo.
  isPlaying() ? mDocument.complete(change) : mDocument.view(change);
}

void TimeBar::refresh() {
  int count = timeSteps();
  setVisible(count > 1 && !mIsReplaced);
  if (count < 2 || mIsReplaced) return setPlaying(false);
  const QSignalBlocker quiet(mSlider);
  mSlider->setRange(0, count - 1);
  int timeStep = mDocument.shown().volume.timeStep;
  mSlider->setValue(timeStep);
  double seconds = mDocument.shown().volume.data->timeStepSeconds;
  QString text = tr("%1 of %2").arg(timeStep + 1).arg(count);
  if (seconds > 0) text += "    " + QString::fromStdString(session::timeText(timeStep, count, seconds));
  mText->setText(text);
}

}  // namespace velum::gui
