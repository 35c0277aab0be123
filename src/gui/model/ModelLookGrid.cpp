#include "gui/model/ModelLookGrid.h"

#include <QVBoxLayout>

#include "gui/kit/Text.h"
#include "gui/kit/Widgets.h"
#include "gui/service/CallLater.h"
#include "scene/ModelLooks.h"
#include "session/command/Command.h"
#include "session/command/LookCommands.h"
#include "session/picture/ModelPictures.h"

namespace velum::gui {

namespace {

constexpr int kColumns = 3, kPictureHeight = 72;
constexpr int kPatienceMs = 6000;  // a view that is busy for longer does not keep the pictures away

}  // namespace

ModelLookGrid::ModelLookGrid(session::Document& document, QWidget* parent)
    : QWidget(parent), mDocument(document), mList(new PictureList(kColumns, kPictureHeight, this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(6);
  layout->addWidget(makeTitle(tr("Look"), this));
  layout->addWidget(mList);
  mList->setObjectName("modelLook");
  mList->setAccessibleName(tr("Look of the model"));
  mList->setToolTip(tr("Palette, light, outlines and background that go together"));
  for (const scene::NamedModelLook& look : scene::modelLooks())
    mList->add(toText(look.name), toText(look.title), toText(look.tip), {});
  mPatience.setSingleShot(true);
  mPatience.setInterval(kPatienceMs);
  connect(mList, &PictureList::chosen, this, &ModelLookGrid::choose);
  connect(&mPatience, &QTimer::timeout, this, &ModelLookGrid::drawPictures);
}

ModelLookGrid::~ModelLookGrid() { mJob.reset(); }

void ModelLookGrid::choose(const QString& name) {
  session::edit(mDocument, session::ChooseModelLook{name.toStdString()});
}

void ModelLookGrid::resizeEvent(QResizeEvent*) { mList->fit(width()); }

void ModelLookGrid::refresh() {
  const scene::Scene& scene = mDocument.scene();
  mList->mark(toText(scene::modelLookName(scene)));
  if (mModel == scene.model.data) return;
  if (mJob) mJob->cancel();
  mModel = scene.model.data;
  mHasTried = false;
  mPictures.clear();
  for (const QString& name : mList->names()) mList->setPicture(name, {});
  if (mModel) mPatience.start();
}

void ModelLookGrid::drawPictures() {
  if (mJob || !mModel || mHasTried) return;
  mPatience.stop();
  mHasTried = true;
  std::vector<std::string> wanted;
  for (const QString& name : mList->names()) wanted.push_back(name.toStdString());
  glm::ivec2 size(mList->pictureSize().width(), mList->pictureSize().height());
  auto work = [this, scene = mDocument.scene(), model = mModel, wanted, size](Progress& progress) {
    session::drawModelPictures(
        scene, wanted, size,
        [&](const std::string& name, const Image& image) {
          callLater(this, [this, model, name = QString::fromStdString(name), picture = toQImage(image)] {
            if (model != mModel) return;
            mPictures.insert(name, QPixmap::fromImage(picture));
            mList->setPicture(name, mPictures.value(name));
          });
        },
        progress);
  };
  mJob = std::make_unique<Job>(work, nullptr);
  // Without a driver for pictures in the background the names alone must do: the error has no place in the window.
  connect(mJob.get(), &Job::finished, this, [this] {
    mJob.release()->deleteLater();
    drawPictures();  // of a model that came meanwhile
  });
  mJob->start();
}

}  // namespace velum::gui
