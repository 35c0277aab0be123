#pragma once
#include <functional>
#include <string>

#include "gui/service/Selection.h"
#include "session/document/Document.h"

namespace velum::gui {

/// The cut that is selected; null when none is.
const scene::Cut* selectedCut(const session::Document& document, const Selection& selection);
/// The same where it is a membrane.
const scene::Cut* selectedMembrane(const session::Document& document, const Selection& selection);

/// Puts a cut where it is to be by the command `cut.place`: what was pulled out of it goes along.
/// @param step  its name for people  @param merge  as of Document::edit()
void placeCut(session::Document& document, const scene::Cut& placed, const std::string& step, bool merge = false);

/// Changes the selected cut as session::editByHand() does, and what was pulled out of it goes along; nothing without
/// one.
void editSelectedCut(session::Document& document, const Selection& selection, const std::string& label,
                     const std::function<void(scene::Cut&)>& change, bool merge = false);
/// The same for what is its own of a membrane; nothing where another cut is selected.
void editSelectedMembrane(session::Document& document, const Selection& selection, const std::string& label,
                          const std::function<void(scene::Membrane&)>& change, bool merge = false);

}  // namespace velum::gui
