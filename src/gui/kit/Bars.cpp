#include "Bars.h"

#include <QHBoxLayout>
#include <QIcon>
#include <QStyle>
#include <QVBoxLayout>
#include <cmath>

#include "RecentFiles.h"

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
  for (const std::string& line : lines) list << QString::fromStdString(line);
  showNote(list.isEmpty() ? text : tr("%1: %2").arg(text, list.join("; ")));
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
  mText->setMinimumWidth(320);
  mBar->setTextVisible(false);
  mBar->setRange(0, 1000);
  auto* cancel = new QPushButton(tr("Cancel"), this);
  cancel->setObjectName("cancel");
  cancel->setToolTip(tr("Stop this (Esc)"));
  layout->addWidget(mText);
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
  QString text = what.isEmpty() ? mTask : QString("%1: %2").arg(mTask, what);
  mText->setText(mText->fontMetrics().elidedText(text, Qt::ElideMiddle, 420));
  mText->setToolTip(text);
  mBar->setValue(int(std::lround(fraction * 1000.0)));
}

EmptyState::EmptyState(QWidget* parent) : QFrame(parent), mRecent(new RecentRow(this)) {
  setObjectName("emptyState");
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(14);
  layout->addStretch(5);
  // What to do, and with what.
  auto* picture = new QLabel(this);
  picture->setPixmap(QIcon(":/velum/velum.svg").pixmap(QSize(112, 112), devicePixelRatioF()));
  layout->addWidget(picture, 0, Qt::AlignHCenter);
  auto* title = new QLabel(tr("Drop a scan here"), this);
  title->setProperty("role", "empty");
  layout->addWidget(title, 0, Qt::AlignHCenter);
  auto* text =
      new QLabel(tr("A folder of DICOM images, NIfTI, NRRD, MetaImage, MRC, TIFF, VTI, SEG-Y or OpenVDB; cell models;\n"
                    "labels and surfaces beside it; a Velum scene, or a picture that was saved from one."),
                 this);
  text->setProperty("role", "muted");
  text->setAlignment(Qt::AlignCenter);
  layout->addWidget(text, 0, Qt::AlignHCenter);
  layout->addSpacing(10);
  // The ways to something to see, the commonest first.
  auto* row = new QHBoxLayout;
  row->setSpacing(10);
  auto add = [&](const QString& name, const QString& tip, void (EmptyState::*signal)(), bool isMain) {
    auto* button = new QPushButton(name, this);
    button->setToolTip(tip);
    if (isMain) button->setProperty("role", "main");
    button->setFixedHeight(36);
    connect(button, &QPushButton::clicked, this, signal);
    row->addWidget(button);
  };
  row->addStretch(1);
  add(tr("Open files..."), tr("Choose files (Ctrl+O)"), &EmptyState::openFiles, true);
  add(tr("Open DICOM folder..."), tr("Choose a folder of images (Ctrl+Shift+O)"), &EmptyState::openFolder, false);
  add(tr("Make a phantom"), tr("Nothing at hand? Computes a torso with ribs, heart and lungs"),
      &EmptyState::makePhantom, false);
  row->addStretch(1);
  layout->addLayout(row);
  // What was open before, and the word that has to be said.
  layout->addWidget(mRecent);
  layout->addStretch(6);
  auto* note = new QLabel(tr("Not a medical device."), this);
  note->setProperty("role", "muted");
  layout->addWidget(note, 0, Qt::AlignHCenter);
  layout->addSpacing(8);
}

}  // namespace velum::gui
