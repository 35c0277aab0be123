#include "gui/window/EmptyState.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "gui/kit/Words.h"
#include "gui/rows/PictureCard.h"
#include "gui/service/RecentFiles.h"
#include "session/document/Showcase.h"

namespace velum::gui {

EmptyState::EmptyState(QWidget* parent) : QFrame(parent), mRecent(new RecentRow(this)) {
  setObjectName("emptyState");
  auto* scroll = new QScrollArea(this);
  scroll->setObjectName("startScroll");
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* page = new QWidget(scroll);
  page->setObjectName("startPage");
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  outer->addWidget(scroll);
  scroll->setWidget(page);
  auto* layout = new QVBoxLayout(page);
  layout->setSpacing(12);
  layout->addStretch(5);
  addWays(layout);
  addSamples(layout);
  // What was open before, and the word that has to be said.
  layout->addWidget(mRecent);
  layout->addStretch(6);
  auto* note = new QLabel(tr("Not a medical device."), this);
  note->setProperty("role", "muted");
  layout->addWidget(note, 0, Qt::AlignHCenter);
  layout->addSpacing(4);
}

/// What to do, and with what.
void EmptyState::addWays(QLayout* layout) {
  auto* title = new QLabel(tr("Drop a scan here"), this);
  title->setProperty("role", "empty");
  title->setAlignment(Qt::AlignCenter);
  layout->addWidget(title);
  auto* text = new QLabel(
      tr("A folder of DICOM images, NIfTI, NRRD, MetaImage, MRC, TIFF, VTI, SEG-Y, OpenVDB, OME-Zarr, N5, Imaris,\n"
         "BigDataViewer; cell models; labels and surfaces beside it; a Velum scene, or a picture that was saved from "
         "one."),
      this);
  text->setProperty("role", "muted");
  text->setAlignment(Qt::AlignCenter);
  layout->addWidget(text);
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
  row->addStretch(1);
  layout->addItem(row);
}

/// What the program is for, to be opened without any data at hand.
void EmptyState::addSamples(QLayout* layout) {
  auto* title = new QLabel(tr("Or begin with a sample"), this);
  title->setProperty("role", "muted");
  title->setAlignment(Qt::AlignCenter);
  layout->addWidget(title);
  auto* row = new QHBoxLayout;
  row->setSpacing(14);
  row->addStretch(1);
  for (const session::Showcase& sample : session::showcases()) {
    QString name = QString::fromUtf8(sample.name.data(), int(sample.name.size()));
    QPixmap picture(QString(":/velum/samples/%1.jpg").arg(name));
    QString text = wordsOf(sample.title), what = wordsOf(sample.what);
    auto* card = new PictureCard(
        text, what, picture.scaled(PictureCard::kPicture, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation),
        this);
    card->setObjectName("sample." + name);
    card->setAccessibleName(tr("Open a sample: %1").arg(text));
    card->setToolTip(tr("%1: %2. Computed, not scanned; nothing is downloaded").arg(text, what));
    connect(card, &QAbstractButton::clicked, this, [this, name] { emit openSample(name); });
    row->addWidget(card);
  }
  row->addStretch(1);
  layout->addItem(row);
}

}  // namespace velum::gui
