#include "gui/model/ModelLookGrid.h"

#include "gui/kit/Text.h"
#include "gui/kit/Widgets.h"
#include "gui/kit/Words.h"
#include "scene/ModelLooks.h"
#include "session/command/Command.h"
#include "session/command/LookCommands.h"
#include "session/picture/ModelPictures.h"

namespace velum::gui {

ModelLookGrid::ModelLookGrid(session::Document& document, QWidget* parent)
    : PictureGrid(document, {.pictureHeight = 72, .draw = session::drawModelPictures, .patienceMs = 20'000}, parent) {
  column().setSpacing(6);
  column().insertWidget(0, makeTitle(tr("Look"), this));
  list().setObjectName("modelLook");
  list().setAccessibleName(tr("Look of the model"));
  list().setToolTip(tr("Palette, light, outlines and background that go together"));
  for (const scene::NamedModelLook& look : scene::modelLooks())
    list().add(textOf(look.name), wordsOf(look.title), wordsOf(look.tip), {});
  connect(&list(), &PictureList::chosen, this, [this](const QString& name) {
    session::edit(this->document(), session::ChooseModelLook{name.toStdString()});
  });
}

void ModelLookGrid::refresh() {
  const scene::Scene& scene = document().shown();
  list().mark(textOf(scene::modelLookName(scene)));
  if (mModel == scene.model.data) return;
  mModel = scene.model.data;
  renew(bool(mModel));
}

}  // namespace velum::gui
