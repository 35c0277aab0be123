#include "gui/window/CarryCommands.h"

#include <QFileInfo>

#include "gui/kit/Text.h"
#include "gui/window/CarryDialog.h"
#include "session/command/Command.h"
#include "session/document/LabelPlace.h"
#include "session/film/Retarget.h"

namespace velum::gui {

namespace {

/// With what is to be said of the data that was read.
std::vector<std::string> notesOfCarried(const scene::Scene& scene, std::vector<std::string> notes) {
  auto add = [&](const auto& data) {
    if (data) notes.insert(notes.end(), data->warnings.begin(), data->warnings.end());
  };
  add(scene.volume.data);
  add(scene.labels.data);
  if (std::string line = session::misplacedLabels(scene); !line.empty()) notes.push_back(line);
  return notes;
}

}  // namespace

void CarryCommands::addAction(QMenu* menu) {
  mCarry = mParts.actions.addForScene(menu, "file.carry", tr("Carr&y over to other data..."),
                                      tr("Show other data as this scene shows its own: look, cuts and film"),
                                      [this] { ask(); });
}

void CarryCommands::refresh(const session::Session& session) {
  mCarry->setEnabled(session.file().isOpen() && bool(session.scene().volume.data));
}

void CarryCommands::ask() {
  const scene::Scene& scene = mParts.document().scene();
  CarryDialog dialog(scene, QFileInfo(toText(scene.volume.source.path)).path(), &mParts.window);
  if (dialog.exec() == QDialog::Accepted) carry(dialog.call());
}

void CarryCommands::carry(const session::CarryScene& call) {
  struct Carried {
    scene::Scene before, after;
    std::vector<std::string> notes;
  };
  auto carried = std::make_shared<Carried>();
  carried->before = mParts.document().scene();
  auto work = [carried, data = session::NewData{call.volume, call.labels, call.structure}](Progress& progress) {
    carried->after = session::retargeted(carried->before, data, progress, carried->notes);
  };
  QString name = QFileInfo(toText(call.volume)).fileName();
  mParts.jobs.start(tr("Carrying over to %1").arg(name), work, [this, carried, call, name] {
    if (mParts.document().scene() != carried->before) return carry(call);
    mParts.toolbox.stop();  // what it had begun was in the data before
    mParts.session.file().carry(std::move(carried->after), session::Call(call).line());
    std::vector<std::string> notes = notesOfCarried(mParts.session.scene(), carried->notes);
    if (!notes.empty()) mParts.messages.showNote(name, notes);
  });
}

}  // namespace velum::gui
