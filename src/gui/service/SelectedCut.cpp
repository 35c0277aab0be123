#include "gui/service/SelectedCut.h"

#include "session/command/Command.h"
#include "session/command/CutCommands.h"
#include "session/extrusion/Pull.h"

namespace velum::gui {

const scene::Cut* selectedCut(const session::Document& document, const Selection& selection) {
  return scene::findCut(document.shown(), selection.cut());
}

const scene::Cut* selectedMembrane(const session::Document& document, const Selection& selection) {
  const scene::Cut* cut = selectedCut(document, selection);
  return cut && scene::isMembrane(*cut) ? cut : nullptr;
}

void placeCut(session::Document& document, const scene::Cut& placed, const std::string& step, bool merge) {
  if (!scene::findCut(document.shown(), placed.id)) return;
  session::edit(document, session::placeOf(placed, session::cutKey(document.shown(), placed.id)), merge, step);
}

void editSelectedCut(session::Document& document, const Selection& selection, const std::string& label,
                     const std::function<void(scene::Cut&)>& change, bool merge) {
  if (!selectedCut(document, selection)) return;
  session::editByHand(
      document, label,
      [&](scene::Scene& scene) {
        scene::Cut& cut = *scene::findCut(scene, selection.cut());
        scene::Cut before = cut;
        change(cut);
        session::carryPulled(scene, before);
      },
      merge);
}

void editSelectedMembrane(session::Document& document, const Selection& selection, const std::string& label,
                          const std::function<void(scene::Membrane&)>& change, bool merge) {
  if (!selectedMembrane(document, selection)) return;
  editSelectedCut(
      document, selection, label, [&](scene::Cut& cut) { change(*cut.membrane); }, merge);
}

}  // namespace velum::gui
