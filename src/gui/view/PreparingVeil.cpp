#include "gui/view/PreparingVeil.h"

#include <QEvent>
#include <QGuiApplication>
#include <QPainter>
#include <utility>

#include "gui/kit/Theme.h"
#include "scene/Scene.h"

namespace velum::gui {

namespace {

constexpr int kPatienceMs = 300;  // after which an older picture of the same data is dimmed
constexpr int kPaintMs = 100;     // how long a paint is waited for: a window that is covered paints nothing
const QColor kDim(10, 11, 13, 165), kClosed(18, 20, 23), kGround(16, 18, 21, 200);
constexpr double kRound = 6.0, kAroundWords = 12.0;

/// Names the data of a scene, so that pictures of two patients are never taken for each other.
std::string dataOf(const scene::Scene& scene) {
  auto name = [](char kind, const scene::Source& source) { return kind + source.path + '\n' + source.series; };
  if (scene.volume.data) return name('v', scene.volume.source);
  if (scene.model.data) return name('m', scene.model.source);
  if (scene.labels.data) return name('l', scene.labels.source);
  return scene.surfaces.empty() ? std::string() : name('s', scene.surfaces.front().source);
}

}  // namespace

PreparingVeil::PreparingVeil(QWidget& view) : QWidget(&view) {
  setObjectName("preparingVeil");
  setAccessibleName(tr("Preparing"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::NoFocus);
  resize(view.size());
  lower();  // what tools draw is the scene's, and stays above
  hide();
  view.installEventFilter(this);
  mPatience.setSingleShot(true);
  mPatience.setInterval(kPatienceMs);
  connect(&mPatience, &QTimer::timeout, this, [this] {
    // While a button is down the user turns the picture and sees it follow: it is not dimmed.
    if (QGuiApplication::mouseButtons() != Qt::NoButton) return mPatience.start();
    set(Kind::Dim);
  });
}

void PreparingVeil::await(const scene::Scene& scene) {
  if (std::exchange(mHasFailed, false)) update();
  if (dataOf(scene) != mShown) {
    mPatience.stop();
    set(Kind::Closed);
  } else if (mKind == Kind::None && !mPatience.isActive()) {
    mPatience.start();
  }
}

void PreparingVeil::awaitLong() {
  if (mKind == Kind::None) set(Kind::Dim);
}

void PreparingVeil::lift(const scene::Scene& shown) {
  mPatience.stop();
  mShown = dataOf(shown);
  set(Kind::None);
}

void PreparingVeil::fail() {
  mHasFailed = true;
  mPatience.stop();
  set(mKind == Kind::Closed ? Kind::Failed : Kind::Dim);  // what is still seen is no picture of the scene
  update();
}

void PreparingVeil::forget() {
  mPatience.stop();
  mShown.clear();
}

void PreparingVeil::set(Kind kind) {
  if (mKind == kind) return;
  mKind = kind;
  mAwaitsPaint = kind != Kind::None;
  mSinceSet.start();
  setVisible(mAwaitsPaint);
  update();
}

bool PreparingVeil::awaitsPaint() const { return mAwaitsPaint && isVisible() && mSinceSet.elapsed() < kPaintMs; }

bool PreparingVeil::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) resize(parentWidget()->size());
  return QWidget::eventFilter(watched, event);
}

void PreparingVeil::paintEvent(QPaintEvent*) {
  mAwaitsPaint = false;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), mKind == Kind::Dim ? kDim : kClosed);
  QString text = mHasFailed ? tr("No picture") : tr("Preparing");
  QSizeF size = QSizeF(painter.fontMetrics().size(0, text)) + QSizeF(2.0 * kAroundWords, kAroundWords);
  QRectF chip(QRectF(rect()).center() - QPointF(0.5 * size.width(), 0.5 * size.height()), size);
  painter.setPen(Qt::NoPen);
  painter.setBrush(kGround);
  painter.drawRoundedRect(chip, kRound, kRound);
  painter.setPen(kOverPicture);
  painter.drawText(chip, Qt::AlignCenter, text);
}

}  // namespace velum::gui
