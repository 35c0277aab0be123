#include "gui/model/ModelCommands.h"

#include <fmt/format.h>

#include <QColorDialog>
#include <QLocale>
#include <algorithm>

#include "gui/service/SelectedCut.h"
#include "session/command/Command.h"
#include "session/command/CutCommands.h"
#include "session/command/LetteringCommands.h"
#include "session/command/MarkCommands.h"
#include "session/command/ModelCommands.h"
#include "session/membrane/MembraneEdit.h"
#include "session/model/TypesAt.h"
#include "session/model/WhatHides.h"
#include "session/structure/StructureSizes.h"

namespace velum::gui {

ModelCommands::ModelCommands(session::Document& document, Selection& selection, QObject* parent)
    : QObject(parent), mDocument(document), mSelection(selection), mFlight(document, nullptr) {}

std::vector<std::string> ModelCommands::named(const Types& types) const {
  return session::typeNames(mDocument.shown(), types);
}

void ModelCommands::setVisible(const Types& types, bool visible) {
  if (!types.empty()) session::edit(mDocument, session::ShowTypes{named(types), visible});
}

void ModelCommands::toggleSolo(const Types& types) {
  if (types.empty()) return;
  session::SoloTypes call{named(types), {}};
  const Shared<Model>& model = mDocument.shown().model.data;
  bool isOfThis = model && mSolo.shown.size() == model->types.size();
  if (isOfThis && session::isSolo(mDocument.shown(), mSolo.alone)) {
    Types shown;
    for (std::uint32_t i = 0; i < mSolo.shown.size(); ++i)
      if (mSolo.shown[i]) shown.push_back(i);
    call.shown = named(shown);
  }
  scene::Scene after = mDocument.shown();
  session::TypeSoloMemory next = session::toggleSoloTypes(after, mSolo, types);
  session::edit(mDocument, call);
  mSolo = next;
}

void ModelCommands::setColor(const Types& types, glm::vec3 color) {
  if (!types.empty()) session::edit(mDocument, session::ColorTypes{named(types), color});
}

void ModelCommands::chooseColor(const Types& types, QWidget* window) {
  if (types.empty()) return;
  glm::vec3 now = glm::clamp(scene::typeColors(mDocument.shown().model)[types[0]], 0.0f, 1.0f);
  QColor color = QColorDialog::getColor(QColor::fromRgbF(now.r, now.g, now.b), window,
                                        types.size() == 1 ? tr("Colour of the type") : tr("Colour of the types"));
  if (color.isValid()) setColor(types, {color.redF(), color.greenF(), color.blueF()});
}

void ModelCommands::resetColor(const Types& types) {
  session::edit(mDocument, session::TakePaletteColor{named(types)});
}

void ModelCommands::reset(const Types& types) { session::edit(mDocument, session::ResetTypes{named(types)}); }

void ModelCommands::flyTo(const session::InstancePlace& place) {
  if (place.radius <= 0.0) return;
  mFlight.start(session::closeUp(mDocument.shown().camera, place.middle, place.radius, 1.0));
}

void ModelCommands::goTo(const Types& types) { flyTo(session::ballAround(mDocument.shown(), types)); }

void ModelCommands::goToInstance(std::uint32_t instance) {
  if (auto place = session::instancePlace(mDocument.shown(), instance)) flyTo(*place);
}

/// What the selected membrane does with types; nothing where another cut is selected.
void ModelCommands::fillMembraneMenu(QMenu& menu, const Types& types) {
  const scene::Cut* cut = selectedMembrane(mDocument, mSelection);
  if (!cut || !mDocument.shown().model.data) return;
  const Model& model = *mDocument.shown().model.data;
  bool isProtected = std::all_of(types.begin(), types.end(), [&](std::uint32_t type) {
    return scene::strengthOf(cut->membrane->field, pathOf(model, model.types[type])) > 0.0;
  });
  QAction* action = menu.addAction(tr("Protect by membrane"));
  action->setToolTip(tr("The selected membrane's sheet goes around it"));
  action->setCheckable(true);
  action->setChecked(isProtected);
  connect(action, &QAction::triggered, this, [this, types](bool on) {
    if (!selectedMembrane(mDocument, mSelection)) return;
    session::edit(mDocument, session::ProtectTypes{named(types), on ? session::kProtectStrength : 0.0,
                                                   session::cutKey(mDocument.shown(), mSelection.cut())});
  });
  menu.addSeparator();
}

void ModelCommands::setInView(const std::string& path, bool kept) {
  session::edit(mDocument, session::KeepInView{path, kept});
}

void ModelCommands::setGhosts(const Types& types, std::optional<scene::Ghosts> ghosts) {
  session::edit(mDocument, session::SetTypeGhosts{named(types), ghosts.value_or(scene::Ghosts::None), !ghosts});
}

void ModelCommands::setTarget(const std::string& path, std::optional<double> visible) {
  session::edit(mDocument, session::SetTypeTarget{path, fmt::format("{:.0f}", visible.value_or(0.0)), !visible});
}

/// What can be done about what stands before a type.
void ModelCommands::fillViewMenu(QMenu& menu, const std::string& path) {
  if (path.empty() || path.find('.') == std::string::npos) return;  // nothing hides all there is
  bool isKept = session::isKeptInView(mDocument.shown(), path);
  QAction* keep = menu.addAction(tr("Keep in view"));
  keep->setCheckable(true);
  keep->setChecked(isKept);
  keep->setToolTip(tr("What stands before it is not drawn, wherever one looks from"));
  connect(keep, &QAction::triggered, this, [this, path](bool on) { setInView(path, on); });
  menu.addAction(tr("What hides this?"), this, [this, path] { emit hidingAsked(QString::fromStdString(path)); })
      ->setToolTip(tr("Says which types stand before it, and by how much"));
  auto wanted = session::visibleTarget(mDocument.shown(), path);
  menu.addAction(
          wanted ? tr("Number to be seen: %1...").arg(QLocale().toString(*wanted, 'f', 0)) : tr("Number to be seen..."),
          this, [this, path] { emit targetWanted(QString::fromStdString(path)); })
      ->setToolTip(tr("So many are to be seen; with the numbers that other types have, as near as can be"));
  if (session::isHeld(mDocument.shown().model, path))
    menu.addAction(wanted ? tr("Any number") : tr("Let its number follow the group"), this,
                   [this, path] { setTarget(path, std::nullopt); })
        ->setToolTip(tr("The number that was set is forgotten: it follows when that of its group is set"));
  menu.addSeparator();
}

void ModelCommands::rename(const std::string& path, const QString& name) {
  session::edit(mDocument, session::RenameType{path, name.toStdString()});
}

void ModelCommands::listInLegend(const std::vector<std::string>& paths, bool listed) {
  session::edit(mDocument, session::ListInLegend{paths, listed});
}

/// What is called how, and what the legend lists.
void ModelCommands::fillNameMenu(QMenu& menu, const Types& types, const std::string& path) {
  if (!path.empty())
    menu.addAction(tr("Rename..."), this, [this, path] { emit renameAsked(QString::fromStdString(path)); })
        ->setToolTip(tr("Give it the name by which it is shown, in pictures, too (F2)"));
  std::vector<std::string> paths = path.empty() ? named(types) : std::vector{path};
  const std::vector<std::string>& entries = mDocument.shown().lettering.entries;
  bool isListed = std::all_of(paths.begin(), paths.end(), [&](const std::string& one) {
    return std::find(entries.begin(), entries.end(), one) != entries.end();
  });
  QAction* list = menu.addAction(tr("List in legend"), this, [this, paths](bool on) { listInLegend(paths, on); });
  list->setCheckable(true);
  list->setChecked(isListed);
  list->setToolTip(tr("The legend names what is listed; where nothing is, the types that are seen most"));
  QAction* name = menu.addAction(tr("Name this"), this, [this, paths] {
    session::AddMark mark{.kind = scene::MarkKind::Name};
    mark.type = paths[0];
    session::edit(mDocument, mark);
  });
  name->setEnabled(paths.size() == 1 && mDocument.shown().lettering.marks.size() < scene::kMostMarks);
  name->setToolTip(tr("Its name beside it in the picture, with a leader; the page Marks lists it"));
  menu.addSeparator();
}

void ModelCommands::fillGhostMenu(QMenu& menu, const Types& types) {
  QMenu* ghosts = menu.addMenu(tr("Ghosts"));
  ghosts->setToolTipsVisible(true);
  std::string path = pathOf(*mDocument.shown().model.data, mDocument.shown().model.data->types[types[0]]);
  auto now = scene::typeLook(mDocument.shown().model, path).ghosts;
  const std::pair<QString, std::optional<scene::Ghosts>> kinds[] = {{tr("As the model"), std::nullopt},
                                                                    {tr("None"), scene::Ghosts::None},
                                                                    {tr("Filled"), scene::Ghosts::Filled},
                                                                    {tr("Contour"), scene::Ghosts::Contour}};
  for (const auto& [name, kind] : kinds) {
    QAction* action = ghosts->addAction(name);
    action->setCheckable(true);
    action->setChecked(now == kind);
    connect(action, &QAction::triggered, this, [this, types, kind = kind] { setGhosts(types, kind); });
  }
}

void ModelCommands::fillMenu(QMenu& menu, const Types& types, const QString& title, const std::string& path) {
  if (types.empty()) return;
  const scene::Scene& scene = mDocument.shown();
  menu.setToolTipsVisible(true);
  menu.addAction(title)->setEnabled(false);
  menu.addSeparator();
  bool visible = session::visibleTypes(scene.model)[types[0]];
  menu.addAction(visible ? tr("Hide") : tr("Show"), this, [this, types, visible] { setVisible(types, !visible); });
  bool solo = session::isSolo(scene, types);
  menu.addAction(solo ? tr("End solo") : tr("Solo"), this, [this, types] { toggleSolo(types); })
      ->setToolTip(solo ? tr("Show again what was shown before") : tr("Show nothing but this (Alt+click on the eye)"));
  menu.addAction(tr("Go there"), this, [this, types] { goTo(types); })
      ->setToolTip(tr("Bring the camera to its instances"));
  menu.addSeparator();
  fillNameMenu(menu, types, path);
  fillViewMenu(menu, path);
  fillMembraneMenu(menu, types);
  fillGhostMenu(menu, types);
  menu.addAction(tr("Colour..."), this, [this, types, window = menu.parentWidget()] { chooseColor(types, window); });
  std::vector<bool> own = session::ownColors(scene.model);
  QAction* palette = menu.addAction(tr("Palette's colour"), this, [this, types] { resetColor(types); });
  palette->setEnabled(std::any_of(types.begin(), types.end(), [&](std::uint32_t i) { return own[i]; }));
  menu.addAction(tr("Reset"), this, [this, types] { reset(types); })
      ->setToolTip(tr("Shown, in the palette's colours, in the finish's material"));
}

}  // namespace velum::gui
