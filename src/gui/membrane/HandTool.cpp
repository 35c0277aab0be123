#include "gui/membrane/HandTool.h"

#include <utility>

#include "gui/service/SelectedCut.h"

namespace velum::gui {

namespace {

/// How far beside the sheet's line on a section a pin is put on it.
constexpr double kReachPixels = 18.0;

using session::Hand;

}  // namespace

HandTool::HandTool(Kind kind, const WindowParts& parts, SheetGrips& grips)
    : mKind(kind),
      mDocument(parts.document()),
      mSelection(parts.selection),
      mSheets(parts.session.membranes()),
      mGrips(grips),
      mToolbox(parts.toolbox),
      mMessages(parts.messages) {
  connect(&mSelection, &Selection::cutChanged, this, [this] {
    if (!selectedMembrane(mDocument, mSelection)) mToolbox.stop(*this);
  });
}

bool HandTool::start() {
  for (const auto& cut : mDocument.shown().cuts)
    if (!selectedMembrane(mDocument, mSelection) && scene::isMembrane(cut)) mSelection.setCut(cut.id);
  if (selectedMembrane(mDocument, mSelection)) return true;
  mMessages.showNote(tr("Add a membrane first: pins and forces are put on its sheet."));
  return false;
}

std::optional<session::SheetPoint> HandTool::sheetUnder(const ViewPoint& at) const {
  auto sheet = mSheets.index(mSelection.cut());
  if (!sheet) return std::nullopt;
  return session::sheetAt(*selectedMembrane(mDocument, mSelection), *sheet, at.space(), at.pixel(), kReachPixels);
}

bool HandTool::putPin(const PointerEvent& event) {
  auto point = sheetUnder(event.at);
  if (!point) {
    mMessages.showNote(tr("A pin holds the sheet: click on the sheet, or on its line in a section."));
    return event.at.isOnSection();  // beside the sheet the picture can be turned
  }
  Hand hand;
  constexpr const char* kLabel = "Add pin";
  editSelectedMembrane(
      mDocument, mSelection, kLabel, [&](scene::Membrane& m) { hand = session::addPin(m, *point); }, true);
  mGrips.begin(event, hand, SheetGrips::Drag::Hand, kLabel);
  mHasPut = true;
  return true;
}

/// Puts a kernel: on a section anywhere; in the 3D picture on the surface that is seen, or else on the sheet.
bool HandTool::putKernel(const PointerEvent& event) {
  auto middle = event.at.world();
  if (!middle)
    if (auto point = sheetUnder(event.at)) middle = point->place;
  if (!middle) return false;
  bool pushes = mKind == Kind::Push;
  const char* label = pushes ? "Push sheet" : "Pull sheet";
  double strength = pushes ? session::kKernelStrength : -session::kKernelStrength;
  double radius = session::defaultRadius(*selectedMembrane(mDocument, mSelection));
  Hand hand;
  editSelectedMembrane(
      mDocument, mSelection, label,
      [&](scene::Membrane& m) { hand = session::addKernel(m, *middle, radius, strength); }, true);
  mGrips.begin(event, hand, SheetGrips::Drag::Radius, label);
  mHasPut = true;
  return true;
}

bool HandTool::press(const PointerEvent& event) {
  bool isPlain = !(event.keys & (Qt::ControlModifier | Qt::AltModifier));
  if (event.button != Qt::LeftButton || !isPlain || !selectedMembrane(mDocument, mSelection)) return false;
  return mKind == Kind::Pin ? putPin(event) : putKernel(event);
}

void HandTool::stop() {
  if (std::exchange(mHasPut, false)) mGrips.letGo();
}

void HandTool::release(const PointerEvent& event) {
  if (!std::exchange(mHasPut, false)) return;
  mGrips.letGo();
  if (!(event.keys & Qt::ShiftModifier)) mToolbox.stop(*this);
}

}  // namespace velum::gui
