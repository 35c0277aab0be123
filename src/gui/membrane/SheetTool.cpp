#include "SheetTool.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>

#include "SheetHandsOverlay.h"
#include "velum/session/cut/CutEdit.h"

namespace velum::gui {

namespace {

constexpr double kReachPixels = 9.0;
/// A drag shorter than this was a click: a kernel has its usual radius then.
constexpr double kClickPixels = 4.0;

using scene::SliceKind;
using session::Hand;
using session::HandKind;

glm::dvec2 toVec(QPointF p) { return {p.x(), p.y()}; }
glm::dvec2 sizeOf(const QWidget* view) { return {std::max(1, view->width()), std::max(1, view->height())}; }

}  // namespace

SheetTool::SheetTool(session::Document& document, ViewGrid& views, Selection& selection, MessageBar& messages,
                     QObject* parent)
    : QObject(parent), mDocument(document), mViews(views), mSelection(selection), mMessages(messages) {
  mOverlays.push_back(new SheetHandsOverlay(*this, mDocument, &views.viewport(), nullptr));
  for (auto kind : {SliceKind::Axial, SliceKind::Coronal, SliceKind::Sagittal})
    mOverlays.push_back(new SheetHandsOverlay(*this, mDocument, &views.slice(kind), &views.slice(kind)));
  qApp->installEventFilter(this);
  connect(&selection, &Selection::cutChanged, this, [this] {
    select({});
    if (!membrane()) stop();
    refresh();
  });
}

const scene::Cut* SheetTool::membrane() const {
  const scene::Cut* cut = scene::findCut(mDocument.scene(), mSelection.cut());
  return cut && scene::isMembrane(*cut) ? cut : nullptr;
}

void SheetTool::refresh() {
  const scene::Cut* cut = membrane();
  if (mSelected.kind != HandKind::None && (!cut || !session::holds(*cut->membrane, mSelected))) select({});
  if (mHover.kind != HandKind::None && (!cut || !session::holds(*cut->membrane, mHover))) mHover = {};
  for (auto* overlay : mOverlays) overlay->refresh();
}

void SheetTool::start(Mode mode) {
  for (const auto& cut : mDocument.scene().cuts)
    if (!membrane() && scene::isMembrane(cut)) mSelection.setCut(cut.id);
  if (!membrane() || mode == Mode::None) {
    if (mode != Mode::None) mMessages.showNote(tr("Add a membrane first: pins and kernels are put on its sheet."));
    return stop();
  }
  if (mMode == mode) return;
  mMode = mode;
  mViews.setPointing(true);
  emit modeChanged(mMode);
}

void SheetTool::stop() {
  if (mMode == Mode::None) return;
  mMode = Mode::None;
  mViews.setPointing(false);
  emit modeChanged(mMode);
}

void SheetTool::select(Hand hand) {
  if (hand.kind == HandKind::Rim) hand.kind = HandKind::Kernel;
  if (mSelected == hand) return;
  mSelected = hand;
  emit selectedChanged(hand);
  refresh();
}

void SheetTool::edit(const char* label, const std::function<void(scene::Membrane&)>& change, bool merge) {
  mDocument.edit(
      label,
      [&](scene::Scene& scene) {
        scene::Cut* cut = scene::findCut(scene, mSelection.cut());
        if (cut && cut->membrane) change(*cut->membrane);
      },
      merge);
}

void SheetTool::removeSelected() {
  const scene::Cut* cut = membrane();
  if (!cut || !session::holds(*cut->membrane, mSelected)) return;
  Hand hand = mSelected;
  select({});
  edit(
      hand.kind == HandKind::Pin ? "Remove pin" : "Remove kernel", [hand](auto& m) { session::removeHand(m, hand); },
      false);
}

void SheetTool::turnSelected() {
  if (mSelected.kind != HandKind::Kernel) return;
  edit(
      "Turn kernel", [hand = mSelected](auto& m) { session::turnKernel(m, hand); }, false);
}

bool SheetTool::isView(const QObject* object) const {
  return object == &mViews.viewport() || sliceOf(qobject_cast<const QWidget*>(object));
}

const SliceView* SheetTool::sliceOf(const QWidget* view) const {
  for (auto kind : {SliceKind::Axial, SliceKind::Coronal, SliceKind::Sagittal})
    if (view && view == &mViews.slice(kind)) return &mViews.slice(kind);
  return nullptr;
}

/// Esc lays the tool down, Del removes what is selected: both before commands that have the same key.
bool SheetTool::takesKey(QObject* watched, QEvent* event) {
  auto* key = static_cast<QKeyEvent*>(event);
  bool isEscape = mMode != Mode::None && key->key() == Qt::Key_Escape;
  bool isRemove = mSelected.kind != HandKind::None && isView(watched) &&
                  (key->key() == Qt::Key_Delete || key->key() == Qt::Key_Backspace);
  if (!isEscape && !isRemove) return false;
  event->accept();
  if (event->type() == QEvent::KeyPress) isEscape ? stop() : removeSelected();
  return true;
}

bool SheetTool::eventFilter(QObject* watched, QEvent* event) {
  bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
  if (isKey && takesKey(watched, event)) return true;
  if (!isView(watched) || !membrane()) return QObject::eventFilter(watched, event);
  auto* view = static_cast<QWidget*>(watched);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      return press(view, static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove:
      return move(view, static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease:
      return release(static_cast<QMouseEvent*>(event));
    case QEvent::Leave:
      if (mDrag == Drag::None) hover(view, {});
      return false;
    default:
      return false;
  }
}

Hand SheetTool::handUnder(const QWidget* view, glm::dvec2 place) const {
  const auto& m = *membrane()->membrane;
  const SliceView* slice = sliceOf(view);
  if (!slice) return session::handAt(m, mDocument.scene().camera, sizeOf(view), place, kReachPixels);
  return mDocument.scene().slices.showCuts ? session::handAt(m, slice->frame(), place, kReachPixels) : Hand{};
}

std::optional<session::SheetPoint> SheetTool::sheetUnder(const QWidget* view, glm::dvec2 place) const {
  const scene::Cut& cut = *membrane();
  auto sheet = mViews.viewport().membranes().index(mSelection.cut());
  if (!sheet) return std::nullopt;
  if (const SliceView* slice = sliceOf(view))
    return session::sheetOnSlice(cut, *sheet, slice->frame(), place, 2.0 * kReachPixels);
  return session::sheetOnRay(cut, *sheet, scene::rayFromPixel(mDocument.scene().camera, sizeOf(view), place));
}

/// Where a kernel is put: on a slice anywhere; in the picture on what is seen, or else on the sheet.
std::optional<glm::dvec3> SheetTool::placeUnder(QWidget* view, glm::dvec2 place) const {
  if (const SliceView* slice = sliceOf(view)) return scene::worldFromSlicePixel(slice->frame(), place);
  if (auto pick = mViews.viewport().pickAt(QPointF(place.x, place.y)); pick && pick->hit) return pick->worldMm;
  if (auto point = sheetUnder(view, place)) return point->placeMm;
  return std::nullopt;
}

/// Sets what the tool sets. @return false where there is no place for it
bool SheetTool::set(QWidget* view, glm::dvec2 place) {
  Hand hand;
  if (mMode == Mode::Pin) {
    auto point = sheetUnder(view, place);
    if (!point) {
      mMessages.showNote(tr("A pin holds the sheet: click on the sheet, or on its line in a slice."));
      return false;
    }
    mLabel = "Add pin";
    edit(
        mLabel, [&](auto& m) { hand = session::addPin(m, *point); }, true);
    mDrag = Drag::Hand;
  } else {
    auto middle = placeUnder(view, place);
    if (!middle) return false;
    mLabel = mMode == Mode::Push ? "Add push kernel" : "Add pull kernel";
    double strength = mMode == Mode::Push ? session::kKernelStrength : -session::kKernelStrength;
    edit(
        mLabel,
        [&](auto& m) { hand = session::addKernel(m, *middle, session::defaultRadiusMm(*membrane()), strength); }, true);
    mDrag = Drag::Radius;
  }
  select(hand);
  return true;
}

bool SheetTool::press(QWidget* view, QMouseEvent* event) {
  if (mDrag != Drag::None) return true;
  glm::dvec2 place = toVec(event->position());
  bool isLeft = event->button() == Qt::LeftButton, isRight = event->button() == Qt::RightButton;
  if ((!isLeft && !isRight) || (event->modifiers() & (Qt::ControlModifier | Qt::AltModifier))) return false;
  mFrom = place;
  mPointer = event->position();
  if (mMode != Mode::None && isLeft) {
    if (!set(view, place)) return mMode == Mode::Pin && sliceOf(view);  // beside the sheet the picture can be turned
  } else {
    Hand hand = handUnder(view, place);
    if (hand.kind == HandKind::None) {
      if (isLeft) select({});
      return false;
    }
    select(hand);
    mDrag = isLeft ? Drag::Hand : Drag::Menu;
    mHover = hand;
    mLabel = session::handLabel(hand);
  }
  mView = view;
  mStart = *membrane()->membrane;
  mStartCamera = mDocument.scene().camera;
  if (const SliceView* slice = sliceOf(view)) mStartFrame = slice->frame();
  if (mHover.kind == HandKind::None || mMode != Mode::None) mHover = mSelected;
  view->setFocus(Qt::MouseFocusReason);
  return true;
}

void SheetTool::drag(glm::dvec2 place, Qt::KeyboardModifiers keys) {
  const SliceView* slice = sliceOf(mView);
  scene::Membrane now = mStart;
  if (mDrag == Drag::Radius) {
    if (glm::length(place - mFrom) < kClickPixels) return;
    auto& kernel = now.field.kernels[std::size_t(mSelected.index)];
    kernel.radiusMm = slice ? session::radiusOfDrag(mStartFrame, mFrom, place)
                            : session::radiusOfDrag(mStartCamera, sizeOf(mView), kernel.centreMm, place);
  } else if (slice) {
    now = session::dragHand(mStart, mHover, mStartFrame, mFrom, place);
  } else {
    std::optional<glm::dvec3> along;
    if (keys & Qt::ShiftModifier) along = session::cutFrame(*membrane())[2];
    now = session::dragHand(mStart, mHover, mStartCamera, sizeOf(mView), mFrom, place, along);
  }
  Hand shown = mDrag == Drag::Radius ? Hand{HandKind::Rim, mSelected.index} : mHover;
  edit(
      mLabel,
      [&](scene::Membrane& m) {
        m.pins = now.pins;
        m.field.kernels = now.field.kernels;
      },
      true);
  mTag = QString::fromStdString(session::handText(*membrane(), shown));
  refresh();
}

bool SheetTool::move(QWidget* view, QMouseEvent* event) {
  mPointer = event->position();
  if (mDrag == Drag::None) {
    if (event->buttons() != Qt::NoButton) return false;
    Hand hand = mMode == Mode::None ? handUnder(view, toVec(event->position())) : Hand{};
    hover(view, hand);
    return hand.kind != HandKind::None;
  }
  if (mDrag != Drag::Menu) drag(toVec(event->position()), event->modifiers());
  return true;
}

void SheetTool::hover(QWidget* view, Hand hand) {
  if (mHover == hand) return;
  bool left = hand.kind == HandKind::None;
  mHover = hand;
  if (!left)
    view->setCursor(hand.kind == HandKind::Rim ? Qt::SizeFDiagCursor : Qt::SizeAllCursor);
  else
    view->setCursor(sliceOf(view) ? Qt::CrossCursor : Qt::ArrowCursor);
  refresh();
}

bool SheetTool::release(QMouseEvent* event) {
  if (mDrag == Drag::None) return false;
  if (event->buttons() != Qt::NoButton) return true;
  bool wantsMenu = mDrag == Drag::Menu;
  mDrag = Drag::None;
  mView = nullptr;
  mTag.clear();
  mHover = {};
  mDocument.endMerge();
  if (mMode != Mode::None && !(event->modifiers() & Qt::ShiftModifier)) stop();
  refresh();
  if (wantsMenu) showMenu(event->globalPosition().toPoint());
  return true;
}

void SheetTool::showMenu(QPoint globalPlace) {
  QMenu menu;
  menu.setObjectName("sheetHandMenu");
  if (mSelected.kind == HandKind::Kernel) {
    bool pushes = membrane()->membrane->field.kernels[std::size_t(mSelected.index)].strength > 0;
    connect(menu.addAction(pushes ? tr("&Pull the sheet instead") : tr("&Push the sheet instead")), &QAction::triggered,
            this, &SheetTool::turnSelected);
  }
  connect(menu.addAction(mSelected.kind == HandKind::Pin ? tr("&Remove pin\tDel") : tr("&Remove kernel\tDel")),
          &QAction::triggered, this, &SheetTool::removeSelected);
  menu.exec(globalPlace);
}

}  // namespace velum::gui
