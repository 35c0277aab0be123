#include "gui/service/PictureGrid.h"

#include "gui/service/CallLater.h"

namespace velum::gui {

PictureGrid::PictureGrid(session::Document& document, Kind kind, QWidget* parent)
    : QWidget(parent),
      mDocument(document),
      mKind(std::move(kind)),
      mColumn(new QVBoxLayout(this)),
      mList(new PictureList(mKind.columns, mKind.pictureHeight, this)) {
  mColumn->setContentsMargins(0, 0, 0, 0);
  mColumn->addWidget(mList);
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

bool PictureGrid::isComplete() const { return !mJob && (!mayDraw() || missing().isEmpty()); }

void PictureGrid::drawPictures() {
  QStringList names = missing();
  if (mJob || !mayDraw() || names.isEmpty()) return;
  mPatience.stop();
  std::vector<std::string> wanted;
  for (const QString& name : names) wanted.push_back(name.toStdString());
  mTried.unite(QSet<QString>(names.begin(), names.end()));
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
  // When a driver draws nothing, the error is not shown in the window.
  connect(mJob.get(), &Job::finished, this, [this] {
    mJob.release()->deleteLater();
    drawPictures();
  });
  mJob->start();
}

void PictureGrid::takePicture(const QString& name, const QImage& picture) {
  QPixmap pixmap = QPixmap::fromImage(picture);
  mPictures.insert(name, pixmap);
  mList->setPicture(name, pixmap);
}

}  // namespace velum::gui
