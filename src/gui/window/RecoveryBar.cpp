#include "RecoveryBar.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "kit/SayTime.h"

namespace velum::gui {

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
  auto* restore = addButton(tr("&Restore"), tr("Open it as it was at the last change"), "main");
  auto* discard = addButton(tr("&Discard..."), tr("Delete this work for good"), "quiet");
  mLater = addButton(tr("&Later"), tr("Keep it; it is offered again at the next start"), "quiet");
  connect(restore, &QPushButton::clicked, this, &RecoveryBar::restoreWanted);
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
  std::erase_if(work, [](const session::LostWork& one) { return !one.isReadable; });
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
  QString title = work.title.empty() ? tr("a scene") : QString::fromStdString(work.title);
  QString more = mWork.size() > 1 ? tr("   (%n more)", nullptr, int(mWork.size()) - 1) : QString();
  mWholeTitle = tr("Unsaved work: %1").arg(title) + more;
  QString last = work.label.empty() ? QString() : tr(", last change: %1").arg(QString::fromStdString(work.label));
  QString where = work.scenePath.empty() ? tr("Never saved") : QString::fromStdString(work.scenePath);
  mWholeText = tr("From %1%2. %3").arg(sayTime(work.when), last, where);
  mText->setToolTip(mWholeText + "\n" + QString::fromStdString(work.folder.string()));
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
