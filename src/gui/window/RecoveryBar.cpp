#include "gui/window/RecoveryBar.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "gui/kit/CoreWords.h"
#include "gui/kit/Words.h"
#include "gui/service/SayTime.h"
#include "scene/Scene.h"

namespace velum::gui {

namespace {

QString sayTitle(const session::LostWork& work) {
  if (!work.isReadable) return RecoveryBar::tr("Unsaved work that cannot be read");
  return RecoveryBar::tr("Unsaved work: %1")
      .arg(work.title.empty() ? RecoveryBar::tr("a scene") : QString::fromStdString(work.title));
}

QString sayText(const session::LostWork& work) {
  QString whyNot = inWords(work.whyNot), time = sayTime(work.when);
  if (!work.isReadable)
    return RecoveryBar::tr("From %1. %2 (%3)").arg(time, QString::fromStdString(work.folder.string()), whyNot);
  QString last = work.label.empty() ? QString() : RecoveryBar::tr(", last change: %1").arg(stepText(work.label));
  QString where = work.scenePath.empty() ? RecoveryBar::tr("Never saved") : QString::fromStdString(work.scenePath);
  QString damage = work.isWhole ? QString() : RecoveryBar::tr(". What came later cannot be read (%1)").arg(whyNot);
  return RecoveryBar::tr("From %1%2. %3%4").arg(time, last, where, damage);
}

}  // namespace

RecoveryBar::RecoveryBar(QWidget* parent) : QFrame(parent), mTitle(new QLabel(this)), mText(new QLabel(this)) {
  setObjectName("recoveryBar");
  setAccessibleName(tr("Unsaved work of an earlier session"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(14, 9, 8, 9);
  layout->setSpacing(8);
  auto* texts = new QVBoxLayout;
  texts->setSpacing(1);
  mTitle->setProperty("role", "title");
  mTitle->setTextFormat(Qt::PlainText);
  mText->setProperty("role", "muted");
  mText->setTextFormat(Qt::PlainText);
  // A long path is cut rather than making the window wide.
  for (QLabel* label : {mTitle, mText}) label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  texts->addWidget(mTitle);
  texts->addWidget(mText);
  layout->addLayout(texts, 1);
  mRestore = addButton(tr("&Restore"), tr("Open it as it was at the last change"), "main");
  auto* discard = addButton(tr("&Discard..."), tr("Delete this work for good"), "quiet");
  mLater = addButton(tr("L&ater"), tr("Keep it; it is offered again at the next start"), "quiet");
  connect(mRestore, &QPushButton::clicked, this, &RecoveryBar::restoreWanted);
  connect(discard, &QPushButton::clicked, this, &RecoveryBar::discardWanted);
  connect(mLater, &QPushButton::clicked, this, &RecoveryBar::next);
  hide();
}

QPushButton* RecoveryBar::addButton(const QString& text, const QString& tip, const char* role) {
  auto* button = new QPushButton(text, this);
  button->setToolTip(tip);
  button->setProperty("role", role);
  layout()->addWidget(button);
  return button;
}

void RecoveryBar::offer(std::vector<session::LostWork> work) {
  mWork = std::move(work);
  refresh();
}

void RecoveryBar::next() {
  if (!mWork.empty()) mWork.erase(mWork.begin());
  refresh();
}

void RecoveryBar::refresh() {
  setVisible(!mWork.empty());
  if (mWork.empty()) return;
  const session::LostWork& work = mWork.front();
  QString more = mWork.size() > 1 ? tr("   (%n more)", nullptr, int(mWork.size()) - 1) : QString();
  mWholeTitle = sayTitle(work) + more;
  mWholeText = sayText(work);
  mText->setToolTip(mWholeText + "\n" + QString::fromStdString(work.folder.string()));
  mRestore->setVisible(work.isReadable);
  elide();
}

void RecoveryBar::elide() {
  mTitle->setText(mTitle->fontMetrics().elidedText(mWholeTitle, Qt::ElideMiddle, mTitle->width()));
  mText->setText(mText->fontMetrics().elidedText(mWholeText, Qt::ElideRight, mText->width()));
}

void RecoveryBar::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  // The labels have their new width once the layout is done.
  QMetaObject::invokeMethod(this, &RecoveryBar::elide, Qt::QueuedConnection);
}

}  // namespace velum::gui
