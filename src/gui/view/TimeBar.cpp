#include "gui/view/TimeBar.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <cmath>

#include "gui/kit/Words.h"
#include "session/lettering/TimeStamp.h"

namespace velum::gui {

namespace {

constexpr double kStepsPerSecond = 10.0;  // where the views keep up

auto toTimeStep(int timeStep) {
  return [timeStep](scene::Scene& scene) { scene.volume.timeStep = timeStep; };
}

}  // namespace

TimeBar::TimeBar(session::Document& document, Player& player, QWidget* parent)
    : QFrame(parent),
      mDocument(document),
      mPlayer(player),
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
  mSeries.frames = [this] { return scene::FilmFrames{0.0, kStepsPerSecond, timeSteps()}; };
  mSeries.now = [this] { return mDocument.shown().volume.timeStep / kStepsPerSecond; };
  mSeries.show = [this](double time) { show(int(std::lround(time * kStepsPerSecond))); };
  mSeries.keepsTime = false;
  mSeries.loops = true;
  connect(&player, &Player::changed, this, &TimeBar::showPlaying);
  connect(mPlay, &QPushButton::toggled, this, &TimeBar::setPlaying);
  connect(mSlider, &QSlider::valueChanged, this, [this](int timeStep) { mDocument.view(toTimeStep(timeStep)); });
  hide();
}

/// How many there are to go through: none where there is no time, or where a film says which one is seen.
int TimeBar::timeSteps() const {
  const auto& volume = mDocument.shown().volume.data;
  return volume && volume->timeSteps > 1 && !mIsReplaced ? volume->timeSteps : 0;
}

void TimeBar::showPlaying() {
  const QSignalBlocker quiet(mPlay);
  mPlay->setChecked(isPlaying());
  mPlay->setText(isPlaying() ? tr("Pause") : tr("Play"));
}

void TimeBar::step(int steps) {
  int count = timeSteps();
  if (count > 0) show(((mDocument.shown().volume.timeStep + steps) % count + count) % count);
}

void TimeBar::show(int timeStep) {
  auto change = toTimeStep(timeStep);
  // What plays goes on by itself: there is nothing to undo.
  isPlaying() ? mDocument.complete(change) : mDocument.view(change);
}

void TimeBar::refresh() {
  int count = timeSteps();
  setVisible(count > 0);
  if (count == 0) return;
  const QSignalBlocker quiet(mSlider);
  mSlider->setRange(0, count - 1);
  int timeStep = mDocument.shown().volume.timeStep;
  mSlider->setValue(timeStep);
  double seconds = mDocument.shown().volume.data->timeStepSeconds;
  QString text = tr("%1 of %2").arg(timeStep + 1).arg(count);
  if (seconds > 0) text += "    " + localNumber(session::timeText(timeStep, count, seconds));
  mText->setText(text);
}

}  // namespace velum::gui
