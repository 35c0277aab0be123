#include "gui/service/PictureGrid.h"

#include "gui/service/CallLater.h"

namespace velum::gui {

PictureGrid::PictureGrid(session::Document& document, Kind kind, QWidget* parent)
    : QWidget(parent),
      mDocument(document),
      mKind(std::move(kind)),
      mColumn(new QVBoxLayout(this)),
      mList(new PictureList(mKind.columns, mKind.pictureHeight, this)),
      mWhyNot(new QLabel(this)) {
  mColumn->setContentsMargins(0, 0, 0, 0);
  mColumn->addWidget(mList);
  mColumn->addWidget(mWhyNot);
  mWhyNot->setObjectName("noSmallPictures");
  mWhyNot->setProperty("role", "muted");
  mWhyNot->setWordWrap(true);
  mWhyNot->setTextFormat(Qt::PlainText);
  mWhyNot->hide();
  mPatience.setSingleShot(true);
  mPatience.setInterval(mKind.patienceMs);
  connect(&mPatience, &QTimer::timeout, this, &PictureGrid::drawPictures);
}

PictureGrid::~PictureGrid() { mJob.reset(); }

void PictureGrid::resizeEvent(QResizeEvent*) { mList->fit(width()); }

void PictureGrid::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (mKind.onlyVisible) drawPictures();
}

void PictureGrid::renew(bool isOpen) {
  mIsOpen = isOpen;
  ++mTurn;
  mTried.clear();
  if (mKind.keepsOld) return;
  if (mJob) mJob->cancel();
  mPictures.clear();
  for (const QString& name : mList->names()) mList->setPicture(name, {});
  if (isOpen && mKind.patienceMs > 0) mPatience.start();
}

QStringList PictureGrid::missing() const {
  QStringList names;
  for (const QString& name : mList->names())
    if (!mTried.contains(name)) names << name;
  return names;
}

bool PictureGrid::isComplete() const { return !mJob && (!mayDraw() || missing().isEmpty() || !mWhyNot->isHidden()); }

void PictureGrid::drawPictures() {
  QStringList names = missing();
  if (mJob || !mayDraw() || names.isEmpty()) return;
  mPatience.stop();
  std::vector<std::string> wanted;
  for (const QString& name : names) wanted.push_back(name.toStdString());
  mAwaited = QSet<QString>(names.begin(), names.end());
  mTried.unite(mAwaited);
  glm::ivec2 size(mList->pictureSize().width(), mList->pictureSize().height());
  auto work = [this, draw = mKind.draw, scene = mDocument.shown(), wanted, size, turn = mTurn](Progress& progress) {
    auto done = [&](const std::string& name, const Image& image) {
      callLater(this, [this, turn, name = QString::fromStdString(name), picture = toQImage(image)] {
        if (turn == mTurn || mKind.keepsOld) takePicture(name, picture);
      });
    };
    draw(scene, wanted, size, done, progress);
  };
  mJob = std::make_unique<Job>(work, nullptr);
  connect(mJob.get(), &Job::finished, this, [this](bool, const QString& error) { end(error); });
  mJob->start();
}

/// What has failed is tried again when the machine is free the next time, not at once.
void PictureGrid::end(const QString& error) {
  mJob.release()->deleteLater();
  mWhyNot->setVisible(!error.isEmpty());
  if (error.isEmpty()) return drawPictures();
  mWhyNot->setText(tr("No small pictures: %1").arg(error));
  mTried.subtract(mAwaited);
}

void PictureGrid::takePicture(const QString& name, const QImage& picture) {
  QPixmap pixmap = QPixmap::fromImage(picture);
  mPictures.insert(name, pixmap);
  mAwaited.remove(name);
  mList->setPicture(name, pixmap);
}

}  // namespace velum::gui
