#include "gui/kit/Messages.h"

#include <QHBoxLayout>
#include <QStyle>
#include <algorithm>
#include <cmath>

#include "gui/kit/CoreWords.h"

namespace velum::gui {

MessageBar::MessageBar(QWidget* parent) : QFrame(parent), mText(new QLabel(this)) {
  setObjectName("messageBar");
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(14, 7, 8, 7);
  mText->setWordWrap(true);
  mText->setTextFormat(Qt::PlainText);
  mText->setTextInteractionFlags(Qt::TextSelectableByMouse);
  layout->addWidget(mText, 1);
  auto* close = new QPushButton(tr("Dismiss"), this);
  close->setProperty("role", "quiet");
  close->setToolTip(tr("Close this message"));
  layout->addWidget(close, 0, Qt::AlignTop);
  connect(close, &QPushButton::clicked, this, &QWidget::hide);
  hide();
}

void MessageBar::showNote(const QString& text, const std::vector<std::string>& lines) {
  QStringList list;
  for (const std::string& line : lines) list << inWords(line);
  QString said = list.join("; ");
  if (text.isEmpty() && !said.isEmpty()) return showNote(said.left(1).toUpper() + said.mid(1));
  showNote(list.isEmpty() ? text : tr("%1: %2").arg(text, said));
}

void MessageBar::showText(const char* kind, const QString& text) {
  setProperty("kind", kind);
  style()->unpolish(this);
  style()->polish(this);
  mText->setText(text);
  show();
}

ProgressStrip::ProgressStrip(QWidget* parent) : QFrame(parent), mText(new QLabel(this)), mBar(new QProgressBar(this)) {
  setObjectName("progressStrip");
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(14, 6, 8, 6);
  layout->setSpacing(14);
  // A long text must not make the window wider.
  mText->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  mBar->setMinimumWidth(60);
  mBar->setTextVisible(false);
  mBar->setRange(0, 1000);
  auto* cancel = new QPushButton(tr("Cancel"), this);
  cancel->setObjectName("cancel");
  cancel->setToolTip(tr("Stop this (Esc)"));
  layout->addWidget(mText, 2);
  layout->addWidget(mBar, 1);
  layout->addWidget(cancel);
  connect(cancel, &QPushButton::clicked, this, &ProgressStrip::cancelled);
  hide();
}

void ProgressStrip::begin(const QString& what) {
  mTask = what;
  setProgress(0.0, {});
  show();
}

void ProgressStrip::setProgress(double fraction, const QString& what) {
  QString text = what.isEmpty() ? mTask : QString("%1: %2").arg(mTask, inWords(what));
  mText->setText(mText->fontMetrics().elidedText(text, Qt::ElideMiddle, std::max(120, mText->width())));
  mText->setToolTip(text);
  mBar->setValue(int(std::lround(fraction * 1000.0)));
}

}  // namespace velum::gui
