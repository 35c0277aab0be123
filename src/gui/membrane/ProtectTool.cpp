#include "gui/membrane/ProtectTool.h"

#include "core/Text.h"
#include "gui/kit/Text.h"
#include "gui/kit/Words.h"
#include "gui/service/SelectedCut.h"
#include "session/command/Command.h"
#include "session/command/CutCommands.h"
#include "session/command/ModelCommands.h"
#include "session/command/StructureCommands.h"
#include "session/membrane/MembraneEdit.h"
#include "session/structure/StructureEdit.h"

namespace velum::gui {

ProtectTool::ProtectTool(bool letThrough, const WindowParts& parts)
    : mLetThrough(letThrough),
      mDocument(parts.document()),
      mSelection(parts.selection),
      mToolbox(parts.toolbox),
      mMessages(parts.messages) {
  connect(&mSelection, &Selection::cutChanged, this, [this] { mToolbox.stop(*this); });
}

bool ProtectTool::start() { return selectedMembrane(mDocument, mSelection); }

void ProtectTool::click(const PointerEvent& event) {
  auto place = event.at.material();
  if (!place) return;
  int structure = event.at.structure();
  double strength = mLetThrough ? 0.0 : session::kProtectStrength;
  std::optional<session::Tissue> tissue;
  const scene::Scene& scene = mDocument.shown();
  bool isType = event.at.type() >= 0;
  bool isStructure = isType || (structure > 0 && scene.labels.visible);
  std::string cut = session::cutKey(scene, mSelection.cut()),
              step = mLetThrough ? "Let sheet through" : "Protect from sheet";
  if (isType)
    session::edit(mDocument,
                  session::ProtectTypes{session::typeNames(scene, {std::uint32_t(event.at.type())}), strength, cut},
                  false, step);
  else if (isStructure)
    session::edit(mDocument, session::ProtectStructures{session::structureNames(scene, {structure}), strength, cut},
                  false, step);
  else
    editSelectedMembrane(mDocument, mSelection, step, [&](scene::Membrane& membrane) {
      tissue = session::protectTissue(membrane, scene.volume, *place, strength);
    });
  QString what;
  if (isType)
    what = typeText(scene.model, std::uint32_t(event.at.type()));
  else if (isStructure)
    what = QString::fromStdString(session::structureName(scene, structure));
  else if (tissue)
    what = tr("values around %1").arg(localNumber(tidyNumber(tissue->value)));
  if (what.isEmpty()) return mMessages.showNote(tr("Nothing stands out here; click well inside of what you mean"));
  mMessages.showNote((mLetThrough ? tr("Let through: %1") : tr("Protected: %1")).arg(what));
  if (!(event.keys & Qt::ShiftModifier)) mToolbox.stop(*this);
}

}  // namespace velum::gui
