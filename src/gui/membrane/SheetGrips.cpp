#include "gui/membrane/SheetGrips.h"

#include <QMenu>
#include <utility>

#include "gui/kit/Words.h"
#include "gui/service/SelectedCut.h"
#include "gui/tool/HandlePaint.h"
#include "session/cut/CutEdit.h"

namespace velum::gui {

namespace {

constexpr double kGripReachPixels = 9.0;
/// A drag shorter than this was a click: a kernel has its usual radius then.
constexpr double kClickPixels = 4.0;

using session::Hand;
using session::HandKind;

}  // namespace

SheetGrips::SheetGrips(session::Document& document, Selection& selection, Toolbox& toolbox, QObject* parent)
    : QObject(parent), mDocument(document), mSelection(selection), mToolbox(toolbox) {
  connect(&selection, &Selection::cutChanged, this, [this] {
    select({});
    mToolbox.repaint();
  });
}

void SheetGrips::refresh() {
  const scene::Cut* cut = selectedMembrane(mDocument, mSelection);
  if (mSelected.kind != HandKind::None && (!cut || !session::holds(*cut->membrane, mSelected))) select({});
  if (mHover.kind != HandKind::None && (!cut || !session::holds(*cut->membrane, mHover))) mHover = {};
}

void SheetGrips::select(Hand hand) {
  if (hand.kind == HandKind::Rim) hand.kind = HandKind::Kernel;
  if (mSelected == hand) return;
  mSelected = hand;
  emit selectedChanged(hand);
  mToolbox.repaint();
}

void SheetGrips::setHover(Hand hand) {
  if (std::exchange(mHover, hand) != hand) mToolbox.repaint();
}

void SheetGrips::removeSelected() {
  const scene::Cut* cut = selectedMembrane(mDocument, mSelection);
  if (!cut || !session::holds(*cut->membrane, mSelected)) return;
  Hand hand = mSelected;
  select({});
  editSelectedMembrane(mDocument, mSelection, hand.kind == HandKind::Pin ? "Remove pin" : "Remove force",
                       [hand](scene::Membrane& m) { session::removeHand(m, hand); });
}

void SheetGrips::turnSelected() {
  if (mSelected.kind != HandKind::Kernel) return;
  editSelectedMembrane(mDocument, mSelection, "Turn force",
                       [hand = mSelected](scene::Membrane& m) { session::turnKernel(m, hand); });
}

KeyAnswer SheetGrips::key(const KeyStroke& stroke) {
  bool isRemove = stroke.key == Qt::Key_Delete || stroke.key == Qt::Key_Backspace;
  if (!isRemove || !stroke.view || mSelected.kind == HandKind::None) return {};
  return [this] { removeSelected(); };
}

Hand SheetGrips::handUnder(const ViewPoint& at) const {
  const scene::Cut* cut = selectedMembrane(mDocument, mSelection);
  return cut ? session::handAt(*cut->membrane, at.space(), at.pixel(), kGripReachPixels) : Hand{};
}

std::optional<Qt::CursorShape> SheetGrips::hover(const ViewPoint& at) {
  Hand hand = handUnder(at);
  setHover(hand);
  if (hand.kind == HandKind::None) return std::nullopt;
  return hand.kind == HandKind::Rim ? Qt::SizeFDiagCursor : Qt::SizeAllCursor;
}

bool SheetGrips::press(const PointerEvent& event) {
  bool isLeft = event.button == Qt::LeftButton, isRight = event.button == Qt::RightButton;
  if ((!isLeft && !isRight) || (event.keys & (Qt::ControlModifier | Qt::AltModifier))) return false;
  Hand hand = handUnder(event.at);
  if (hand.kind == HandKind::None) {
    if (isLeft) select({});
    return false;
  }
  begin(event, hand, isLeft ? Drag::Hand : Drag::Menu, session::handLabel(hand));
  return true;
}

void SheetGrips::begin(const PointerEvent& event, Hand hand, Drag drag, const char* label) {
  select(hand);
  mHover = hand;
  mDrag = drag;
  mLabel = label;
  mView = &event.at.view();
  mStartSpace = event.at.space();
  mStart = *selectedMembrane(mDocument, mSelection)->membrane;
  mFrom = event.at.pixel();
  mPointer = event.at.place();
}

void SheetGrips::drag(const PointerEvent& event) {
  const scene::Cut* cut = selectedMembrane(mDocument, mSelection);
  // What is dragged may have been undone meanwhile.
  if (!cut || mDrag == Drag::None || mDrag == Drag::Menu || !session::holds(*cut->membrane, mHover)) return;
  mPointer = event.at.place();
  glm::dvec2 to = event.at.pixel();
  scene::Membrane now = mStart;
  Hand shown = mHover;
  if (mDrag == Drag::Radius) {
    if (glm::length(to - mFrom) < kClickPixels) return;
    auto& kernel = now.field.kernels[std::size_t(mHover.index)];
    kernel.radius = session::radiusOfDrag(mStartSpace, kernel.centre, mFrom, to);
    shown = Hand{HandKind::Rim, mHover.index};
  } else {
    std::optional<glm::dvec3> along;
    if (event.keys & Qt::ShiftModifier) along = session::cutFrame(*cut)[2];
    now = session::dragHand(mStart, mHover, mStartSpace, mFrom, to, along);
  }
  editSelectedMembrane(
      mDocument, mSelection, mLabel,
      [&](scene::Membrane& m) {
        m.pins = now.pins;
        m.field.kernels = now.field.kernels;
      },
      true);
  mTag = localNumber(
      session::handText(scene::lengthFormat(mDocument.shown()), *selectedMembrane(mDocument, mSelection), shown));
  mToolbox.repaint();
}

void SheetGrips::release(const PointerEvent& event) {
  bool wantsMenu = mDrag == Drag::Menu;
  letGo();
  if (wantsMenu) showMenu(event.globalPlace);
}

void SheetGrips::letGo() {
  mDrag = Drag::None;
  mView = nullptr;
  mTag.clear();
  mHover = {};
  mDocument.endMerge();
  mToolbox.repaint();
}

void SheetGrips::showMenu(QPoint globalPlace) {
  const scene::Cut* cut = selectedMembrane(mDocument, mSelection);
  if (!cut || !session::holds(*cut->membrane, mSelected)) return;
  QMenu menu;
  menu.setObjectName("sheetHandMenu");
  if (mSelected.kind == HandKind::Kernel) {
    bool pushes = cut->membrane->field.kernels[std::size_t(mSelected.index)].strength > 0;
    connect(menu.addAction(pushes ? tr("&Pull the sheet instead") : tr("&Push the sheet instead")), &QAction::triggered,
            this, &SheetGrips::turnSelected);
  }
  connect(menu.addAction(mSelected.kind == HandKind::Pin ? tr("&Remove pin\tDel") : tr("&Remove force\tDel")),
          &QAction::triggered, this, &SheetGrips::removeSelected);
  menu.exec(globalPlace);
}

void SheetGrips::paint(ViewPainter& over) const {
  const scene::Cut* cut = selectedMembrane(mDocument, mSelection);
  if (!cut) return;
  over.painter.setOpacity(cut->enabled ? 1.0 : 0.45);
  paintHands(over.painter, *cut, over.space, {mSelected, mHover});
  over.painter.setOpacity(1.0);
  if (&over.view == mView) drawTag(over.painter, mPointer, over.size, mTag);
}

}  // namespace velum::gui
