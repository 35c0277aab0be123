#include "gui/look/FinishGrid.h"

#include <QVBoxLayout>

#include "gui/service/CallLater.h"
#include "scene/Finishes.h"
#include "session/command/Command.h"
#include "session/command/LookCommands.h"
#include "session/picture/FinishPictures.h"

namespace velum::gui {

namespace {

constexpr int kColumns = 3, kPictureHeight = 84;

QString textOf(std::string_view text) { return QString::fromUtf8(text.data(), int(text.size())); }

}  // namespace

FinishGrid::FinishGrid(session::Document& document, QWidget* parent)
    : QWidget(parent), mDocument(document), mList(new PictureList(kColumns, kPictureHeight, this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(mList);
  mList->setObjectName("finish");
  mList->setAccessibleName(tr("Finish"));
  mList->setToolTip(tr("Contours, lit spheres, strokes and paper that belong together"));
  for (const scene::NamedFinish& finish : scene::finishes())
    mList->add(textOf(finish.name), textOf(finish.title), textOf(finish.tip), {});
  connect(mList, &PictureList::chosen, this,
          [this](const QString& name) { session::edit(mDocument, session::ChooseFinish{name.toStdString()}); });
}

FinishGrid::~FinishGrid() { mJob.reset(); }

void FinishGrid::resizeEvent(QResizeEvent*) { mList->fit(width()); }

void FinishGrid::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  drawPictures();
}

FinishGrid::Key FinishGrid::keyOf(const scene::Scene& scene) const {
  return {scene.volume.data, scene.volume.channel, scene::currentTransfer(scene.volume)};
}

void FinishGrid::refresh() {
  const scene::Scene& scene = mDocument.scene();
  setEnabled(scene::hasData(scene));
  mWanted = keyOf(scene);
  mList->mark(textOf(scene::finishName(scene.finish)));
}

bool FinishGrid::isComplete() const { return !mJob && (mWanted == mDrawn || !mWanted.volume || !isVisible()); }

void FinishGrid::drawPictures() {
  if (mJob || !mWanted.volume || mWanted == mDrawn || !isVisible()) return;
  std::vector<std::string> names;
  for (const QString& name : mList->names()) names.push_back(name.toStdString());
  glm::ivec2 size(mList->pictureSize().width(), mList->pictureSize().height());
  auto work = [this, scene = mDocument.scene(), names, size](Progress& progress) {
    session::drawFinishPictures(
        scene, names, size,
        [&](const std::string& name, const Image& image) {
          callLater(this, [this, name = QString::fromStdString(name), picture = toQImage(image)] {
            mList->setPicture(name, QPixmap::fromImage(picture));
          });
        },
        progress);
  };
  mJob = std::make_unique<Job>(work, nullptr);
  // Without a driver for pictures in the background the names alone must do: the error has no place in the window.
  connect(mJob.get(), &Job::finished, this, [this, drawn = mWanted] {
    mJob.release()->deleteLater();
    mDrawn = drawn;
    drawPictures();
  });
  mJob->start();
}

}  // namespace velum::gui
