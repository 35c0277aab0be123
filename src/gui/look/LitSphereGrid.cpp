#include "gui/look/LitSphereGrid.h"

#include <QFileDialog>
#include <QPainter>
#include <QPainterPath>
#include <QVBoxLayout>
#include <exception>

#include "gui/kit/CoreWords.h"
#include "gui/kit/Words.h"
#include "scene/LitSpheres.h"
#include "session/command/Command.h"
#include "session/command/LookCommands.h"

namespace velum::gui {

namespace {

constexpr int kColumns = 5, kPictureHeight = 52;

/// The sphere alone, round.
QPixmap roundPicture(const Image& image) {
  QPixmap picture(image.width, image.height);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath round;
  round.addEllipse(QRectF(0, 0, image.width, image.height).adjusted(4, 4, -4, -4));
  painter.setClipPath(round);
  painter.drawImage(picture.rect().adjusted(4, 4, -4, -4), toQImage(image));
  return picture;
}

}  // namespace

LitSphereGrid::LitSphereGrid(session::Document& document, QWidget* parent)
    : QWidget(parent), mDocument(document), mList(new PictureList(kColumns, kPictureHeight, this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addWidget(mList);
  auto* add = new QPushButton(tr("Add your own..."), this);
  add->setObjectName("addLitSphere");
  add->setProperty("role", "quiet");
  add->setToolTip(tr("A picture of a painted sphere that fills it to its edges: .png, .tif or .exr"));
  layout->addWidget(add, 0, Qt::AlignLeft);
  mList->setObjectName("litSphere");
  mList->setAccessibleName(tr("Lit sphere"));
  mList->setToolTip(tr("How the material looks from each side, where structures have none of their own"));
  connect(mList, &PictureList::chosen, this,
          [this](const QString& name) { session::edit(mDocument, session::ChooseLitSphere{name.toStdString()}); });
  connect(add, &QPushButton::clicked, this, &LitSphereGrid::askOwn);
  fill();
}

void LitSphereGrid::resizeEvent(QResizeEvent*) { mList->fit(width()); }

void LitSphereGrid::fill() {
  mList->clear();
  for (const scene::LitSphereName& sphere : scene::litSpheres())
    mList->add(textOf(sphere.name), wordsOf(sphere.title), wordsOf(sphere.title),
               roundPicture(scene::makeLitSphere(sphere.name)));
  for (const scene::LitSphere& own : mOwn) {
    QString name = QString::fromStdString(own.name);
    mList->add(name, name, QString::fromStdString(own.source.path), own.data ? roundPicture(*own.data) : QPixmap());
  }
  mList->fit(width());
}

void LitSphereGrid::refresh() {
  const scene::Finish& finish = mDocument.shown().finish;
  setEnabled(scene::hasData(mDocument.shown()));
  if (!(finish.spheres == mOwn)) {
    mOwn = finish.spheres;
    fill();
  }
  mList->mark(QString::fromStdString(finish.sphere));
}

void LitSphereGrid::addOwn(const QString& path) {
  try {
    session::edit(mDocument, session::ChooseLitSphere{path.toStdString()});
  } catch (const std::exception& error) {
    emit failed(inWords(error.what()));
  }
}

void LitSphereGrid::askOwn() {
  QString path = QFileDialog::getOpenFileName(this, tr("Add lit sphere"), {},
                                              tr("Pictures (*.png *.tif *.tiff *.exr);;All files (*)"));
  if (!path.isEmpty()) addOwn(path);
}

}  // namespace velum::gui
