#include "gui/look/FinishGrid.h"

#include "gui/kit/Words.h"
#include "scene/Finishes.h"
#include "session/command/Command.h"
#include "session/command/LookCommands.h"
#include "session/picture/FinishPictures.h"

namespace velum::gui {

FinishGrid::FinishGrid(session::Document& document, QWidget* parent)
    : PictureGrid(document,
                  {.pictureHeight = 84, .draw = session::drawFinishPictures, .keepsOld = true, .onlyVisible = true},
                  parent) {
  list().setObjectName("finish");
  list().setAccessibleName(tr("Finish"));
  list().setToolTip(tr("Contours, lit spheres, strokes and paper that belong together"));
  for (const scene::NamedFinish& finish : scene::finishes())
    list().add(textOf(finish.name), wordsOf(finish.title), wordsOf(finish.tip), {});
  connect(&list(), &PictureList::chosen, this,
          [this](const QString& name) { session::edit(this->document(), session::ChooseFinish{name.toStdString()}); });
}

void FinishGrid::refresh() {
  const scene::Scene& scene = document().shown();
  setEnabled(scene::hasData(scene));
  list().mark(textOf(scene::finishName(scene)));
  Key key{scene.volume.data, scene.volume.channel, scene::currentTransfer(scene.volume)};
  if (!key.volume) {
    key.model = scene.model;
    key.lighting = scene.lighting;
    key.top = scene.background.top, key.bottom = scene.background.bottom;
  }
  // Neither changes anything that is seen.
  key.model.targets.clear();
  scene::dropNames(key.model);
  if (key == mKey) return;
  mKey = key;
  renew(key.volume || key.model.data);
}

}  // namespace velum::gui
