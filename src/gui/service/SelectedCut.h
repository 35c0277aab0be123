#pragma once
#include <functional>
#include <string>

#include "gui/service/Selection.h"
#include "session/document/Document.h"

namespace velum::gui {

/// The cut that is selected; null when none is.
const scene::Cut* selectedCut(const session::Document& document, const Selection& selection);
/// The cut that is selected, if it is a membrane; else null.
const scene::Cut* selectedMembrane(const session::Document& document, const Selection& selection);

/// Moves a cut to its new place by the command `cut.place`; structures that were pulled out of the cut move with it.
/// @param placed  the cut as it is to be  @param step  the undo step's name for people  @param merge  as of
/// Document::edit()
void placeCut(session::Document& document, const scene::Cut& placed, const std::string& step, bool merge = false);

/// Changes the selected cut as session::editByHand() does; structures that were pulled out of the cut move with it.
/// Does nothing when no cut is selected.
void editSelectedCut(session::Document& document, const Selection& selection, const std::string& label,
                     const std::function<void(scene::Cut&)>& change, bool merge = false);
/// Changes the selected cut's membrane in the same way. Does nothing when the selected cut is no membrane.
void editSelectedMembrane(session::Document& document, const Selection& selection, const std::string& label,
                          const std::function<void(scene::Membrane&)>& change, bool merge = false);

}  // namespace velum::gui
