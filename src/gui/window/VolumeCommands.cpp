#include "gui/window/VolumeCommands.h"

#include <QDir>
#include <QFileInfo>
#include <QInputDialog>

#include "core/BrickCache.h"
#include "core/Error.h"
#include "gui/kit/CoreWords.h"
#include "gui/kit/Length.h"
#include "gui/window/RawDialog.h"
#include "gui/window/VoxelSizeDialog.h"
#include "scene/json/Paths.h"
#include "session/command/Command.h"
#include "session/command/DocumentCommands.h"
#include "session/command/LookCommands.h"
#include "session/document/LabelPlace.h"
#include "session/document/PyramidBeside.h"
#include "session/document/WorkFile.h"

namespace velum::gui {

namespace {

/// TIFF is what microscopes write, as a file or plane by plane.
bool isOfMicroscope(const std::string& path) {
  QFileInfo file(QString::fromStdString(path));
  auto isTiff = [](const QString& suffix) {
    return suffix.compare("tif", Qt::CaseInsensitive) == 0 || suffix.compare("tiff", Qt::CaseInsensitive) == 0;
  };
  if (!file.isDir()) return isTiff(file.suffix());
  return !QDir(file.filePath()).entryList({"*.tif", "*.tiff"}, QDir::Files).isEmpty();
}

}  // namespace

VolumeCommands::VolumeCommands(const WindowParts& parts, FileLoads& loads) : Room(parts) {
  QMenu* edit = parts.menu(MenuId::Edit);
  edit->addSeparator();
  mVoxelSize = parts.actions.addForScene(edit, "edit.voxelSize", tr("&Voxel size..."),
                                         tr("Say how large the voxels are, where the file does not or is wrong"),
                                         [this] { askVoxelSize(tr("How large is a voxel?")); });
  mLayout =
      parts.actions.addForScene(edit, "edit.layout", tr("&Samples of the file..."),
                                tr("Say what the samples of a file without a header are"), [this] { askLayout(); });
  mLevel = parts.actions.addForScene(edit, "edit.level", tr("Level of de&tail..."),
                                     tr("Choose which level of a pyramid is read, or that it is streamed"),
                                     [this] { askLevel(); });
  mTable = parts.actions.addForScene(parts.menu(MenuId::Look), "look.hideTable", tr("Hi&de the table"),
                                     tr("Leave out what is not part of the largest body: table, head rest, cables"),
                                     [this] { hideTable(mTable->isChecked()); });
  mTable->setCheckable(true);
  connect(&loads, &FileLoads::volumeOpened, this, &VolumeCommands::askWhatIsUnknown);
}

void VolumeCommands::refresh(const session::Session& session) {
  const scene::VolumeLayer& layer = session.shown().volume;
  bool hasFile = layer.data && !layer.source.path.empty();
  mVoxelSize->setEnabled(hasFile);
  mLayout->setEnabled(hasFile && layer.source.raw.dims.x > 0);
  mLevel->setEnabled(hasFile && (layer.data->finer || layer.source.level >= 0));
  mTable->setEnabled(layer.data && layer.data->channels == 1);
  mTable->setChecked(layer.bodyOnly);
}

void VolumeCommands::reread(const QString& step, const scene::Source& source) {
  scene::Scene wanted = mParts.session.shown();
  wanted.volume.source = source;
  session::Call call = session::SetField{"volume.source", scene::getField(wanted, "volume.source")};
  auto make = [call, name = step.toStdString()](const scene::Scene& scene, Progress& progress) {
    session::Edit edit = session::editOf(scene, call, progress);
    edit.step = name;
    return edit;
  };
  auto commit = [this, call](const session::Edit& edit) {
    session::commit(mParts.document(), edit, call);
    std::string misplaced = session::misplacedLabels(mParts.session.shown());
    if (!misplaced.empty()) mParts.messages.showError(inWords(misplaced));
  };
  mParts.jobs.edit(step, {.make = make, .commit = commit});
}

void VolumeCommands::hideTable(bool hidden) {
  mParts.jobs.run(session::HideTable{hidden});
  mTable->setChecked(mParts.session.shown().volume.bodyOnly);  // until it is done
}

void VolumeCommands::askVoxelSize(const QString& why) {
  const scene::VolumeLayer& layer = mParts.session.shown().volume;
  double millimetres = millimetresPer(mParts.session.shown().unit);
  auto* dialog = new VoxelSizeDialog(why, &mParts.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  VoxelSizeForm& form = dialog->form();
  bool isMap = mParts.session.shown().unit == LengthUnit::Angstrom;
  if (layer.data->isSpacingKnown)
    form.setValue(finestSpacing(*layer.data) * millimetres);
  else
    form.setGuess(isMap ? glm::dvec3(millimetres) : VoxelSizeForm::firstGuess(isOfMicroscope(layer.source.path)));
  connect(dialog, &QDialog::accepted, this, [this, dialog, millimetres] {
    scene::Source source = mParts.session.shown().volume.source;
    source.spacing = dialog->form().value() / millimetres;
    reread(tr("Set voxel size"), source);
  });
  dialog->open();
}

void VolumeCommands::askLayout() {
  auto* dialog = new RawDialog(mParts.session.shown().volume.source, &mParts.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this,
          [this, dialog] { reread(tr("Change samples of the file"), dialog->source()); });
  dialog->open();
}

void VolumeCommands::askLevel() {
  const scene::Source& source = mParts.session.shown().volume.source;
  QStringList levels{tr("Streamed, as fine as the screen shows it")};
  try {
    for (const std::string& line : session::levelLines(source))
      levels << tr("Level %1, read whole: %2").arg(levels.size() - 1).arg(QString::fromStdString(line));
  } catch (const InputError& error) {
    return mParts.messages.showError(inWords(error.what()));
  }
  auto* dialog = new QInputDialog(&mParts.window);
  dialog->setObjectName("levelDialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Level of detail"));
  dialog->setLabelText(
      tr("Which level of %1 is to be read?").arg(QFileInfo(QString::fromStdString(source.path)).fileName()));
  dialog->setComboBoxItems(levels);
  dialog->setTextValue(levels.value(source.level + 1));
  connect(dialog, &QInputDialog::textValueSelected, this, [this, levels](const QString& text) {
    scene::Source wanted = mParts.session.shown().volume.source;
    wanted.level = int(levels.indexOf(text)) - 1;
    if (wanted.level != mParts.session.shown().volume.source.level) reread(tr("Choose level of detail"), wanted);
  });
  dialog->open();
}

void VolumeCommands::askWhatIsUnknown() {
  const auto& volume = mParts.session.shown().volume.data;
  if (volume && !volume->isSpacingKnown)
    askVoxelSize(tr("%1 does not say how large its voxels are. Lengths and proportions are right once you say it.")
                     .arg(QString::fromStdString(volume->name)));
}

}  // namespace velum::gui
