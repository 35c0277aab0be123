#include "ModelCommands.h"

#include <QColorDialog>
#include <algorithm>

#include "kit/SelectedCut.h"
#include "velum/session/membrane/MembraneEdit.h"
#include "velum/session/structure/StructureSizes.h"

namespace velum::gui {

ModelCommands::ModelCommands(session::Document& document, Selection& selection, QObject* parent)
    : QObject(parent), mDocument(document), mSelection(selection), mFlight(document, nullptr) {}

void ModelCommands::setVisible(const Types& types, bool visible) {
  if (types.empty()) return;
  mDocument.edit(session::typesLabel(mDocument.scene(), visible ? "Show" : "Hide", types),
                 [&](scene::Scene& scene) { session::setTypesVisible(scene, types, visible); });
}

void ModelCommands::toggleSolo(const Types& types) {
  if (types.empty()) return;
  bool ends = session::isSolo(mDocument.scene(), types);
  session::TypeSoloMemory next;
  mDocument.edit(session::typesLabel(mDocument.scene(), ends ? "End solo of" : "Solo", types),
                 [&](scene::Scene& scene) { next = session::toggleSoloTypes(scene, mSolo, types); });
  mSolo = next;
}

void ModelCommands::setColor(const Types& types, glm::vec3 color) {
  if (types.empty()) return;
  mDocument.edit(session::typesLabel(mDocument.scene(), "Colour", types),
                 [&](scene::Scene& scene) { session::setTypesColor(scene, types, color); });
}

void ModelCommands::chooseColor(const Types& types, QWidget* window) {
  if (types.empty()) return;
  glm::vec3 now = glm::clamp(scene::typeColors(mDocument.scene().model)[types[0]], 0.0f, 1.0f);
  QColor color = QColorDialog::getColor(QColor::fromRgbF(now.r, now.g, now.b), window,
                                        types.size() == 1 ? tr("Colour of the type") : tr("Colour of the types"));
  if (color.isValid()) setColor(types, {color.redF(), color.greenF(), color.blueF()});
}

void ModelCommands::resetColor(const Types& types) {
  mDocument.edit(session::typesLabel(mDocument.scene(), "Palette's colour of", types),
                 [&](scene::Scene& scene) { session::setTypesColor(scene, types, std::nullopt); });
}

void ModelCommands::reset(const Types& types) {
  mDocument.edit(session::typesLabel(mDocument.scene(), "Reset", types),
                 [&](scene::Scene& scene) { session::resetTypes(scene, types); });
}

void ModelCommands::flyTo(const session::InstancePlace& place) {
  if (place.radius <= 0.0) return;
  mFlight.start(session::closeUp(mDocument.scene().camera, place.middle, place.radius, 1.0));
}

void ModelCommands::goTo(const Types& types) { flyTo(session::ballAround(mDocument.scene(), types)); }

void ModelCommands::goToInstance(std::uint32_t instance) {
  if (auto place = session::instancePlace(mDocument.scene(), instance)) flyTo(*place);
}

/// What the selected membrane does with types; nothing where another cut is selected.
void ModelCommands::fillMembraneMenu(QMenu& menu, const Types& types) {
  const scene::Cut* cut = selectedMembrane(mDocument, mSelection);
  if (!cut || !session::protectsTypes(mDocument.scene())) return;
  const auto& strengths = cut->membrane->field.byLabel;
  bool isProtected = std::all_of(types.begin(), types.end(), [&](std::uint32_t type) {
    return std::any_of(strengths.begin(), strengths.end(),
                       [&](const auto& one) { return one.id == int(type) + 1 && one.strength > 0.0; });
  });
  QAction* action = menu.addAction(tr("Protect by membrane"));
  action->setToolTip(tr("The selected membrane's sheet goes around it"));
  action->setCheckable(true);
  action->setChecked(isProtected);
  connect(action, &QAction::triggered, this, [this, types](bool on) {
    const char* verb = on ? "Protect by membrane:" : "No force of";
    editSelectedMembrane(mDocument, mSelection, session::typesLabel(mDocument.scene(), verb, types),
                         [&](scene::Membrane& membrane) {
                           for (std::uint32_t type : types)
                             session::protectStructure(membrane, int(type) + 1, on ? session::kProtectStrength : 0.0);
                         });
  });
  menu.addSeparator();
}

void ModelCommands::fillMenu(QMenu& menu, const Types& types, const QString& title) {
  if (types.empty()) return;
  const scene::Scene& scene = mDocument.scene();
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
  fillMembraneMenu(menu, types);
  menu.addAction(tr("Colour..."), this, [this, types, window = menu.parentWidget()] { chooseColor(types, window); });
  std::vector<bool> own = session::ownColors(scene.model);
  QAction* palette = menu.addAction(tr("Palette's colour"), this, [this, types] { resetColor(types); });
  palette->setEnabled(std::any_of(types.begin(), types.end(), [&](std::uint32_t i) { return own[i]; }));
  menu.addAction(tr("Reset"), this, [this, types] { reset(types); })
      ->setToolTip(tr("Shown, in the palette's colours, in the finish's material"));
}

}  // namespace velum::gui
