// The pointer and the keys in a section view. Left moves the crosshair, or turns the other sections by a knob of its
// lines; the wheel scrolls, with Ctrl it comes nearer; middle or Shift+left pans; right sets the grey window. Tools and
// handles come first: the toolbox is asked.
#include <QApplication>
#include <QContextMenuEvent>
#include <QMouseEvent>
#include <cmath>

#include "gui/kit/Points.h"
#include "gui/kit/Preferences.h"
#include "gui/view/SectionView.h"
#include "gui/view/ViewChange.h"
#include "session/command/Command.h"
#include "session/command/LookCommands.h"
#include "session/section/SectionTool.h"

namespace velum::gui {

namespace {

constexpr double kReachPixels = 10.0;
constexpr double kStillPixels = 3.0;  // a hand that clicks moves less
constexpr double kFarSteps = 10.0;    // with Shift

/// The keys that mean something here even though the window has commands on them.
bool isOwnKey(const QKeyEvent& event) {
  if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier)) return false;
  return event.key() == Qt::Key_R || event.key() == Qt::Key_F;
}

}  // namespace

SectionView::Drag SectionView::dragFor(const QMouseEvent& event) const {
  bool shift = event.modifiers() & Qt::ShiftModifier;
  if (event.button() == Qt::MiddleButton || (event.button() == Qt::LeftButton && shift)) return Drag::Pan;
  if (event.button() == Qt::RightButton) return Drag::Window;
  if (event.button() != Qt::LeftButton) return Drag::None;
  bool isTurn = mHints.showKnobs && mDocument.shown().sections.showCrosshair &&
                session::isOnKnob(session::crosshairLines(mDocument.shown(), mKind, plane()), toVec(event.position()),
                                  kReachPixels);
  return isTurn ? Drag::Turn : Drag::Crosshair;
}

void SectionView::mousePressEvent(QMouseEvent* event) {
  if (mDrag != Drag::None) return;
  if (mToolbox.press(*this, *event)) {
    if (mToolbox.pausesOtherViews()) emit touched();
    return;
  }
  emit touched();
  mDrag = dragFor(*event);
  mDragStart = mDragLast = toVec(event->position());
  mDragScene = mDocument.shown();
  mDragPlane = plane();
  mHasMoved = false;
  if (!mSincePress.isValid() || mSincePress.hasExpired(QApplication::doubleClickInterval()))
    mCrosshairBefore = mDragScene.sections.crosshair;
  mSincePress.start();
  if (mDrag == Drag::Crosshair) dragTo(mDragStart);
  if (mDrag == Drag::Pan) setCursor(Qt::ClosedHandCursor);
  if (mDrag == Drag::Window) setCursor(Qt::SizeAllCursor);
}

void SectionView::dragTo(glm::dvec2 place) {
  emit touched();
  glm::dvec2 step = place - mDragLast, way = place - mDragStart;
  if (glm::length(way) > kStillPixels) mHasMoved = true;
  switch (mDrag) {
    case Drag::Crosshair:
      change(
          [&](scene::Scene& scene) { scene::moveCrosshair(scene, scene::worldFromSectionPixel(mDragPlane, place)); });
      break;
    case Drag::Turn:
      change([&](scene::Scene& scene) {
        scene.sections = session::turnedSections(mDragScene, mKind, mDragPlane, mDragStart, place);
      });
      break;
    case Drag::Pan:
      change([&](scene::Scene& scene) { scene::panSection(scene, mKind, logicalSize(), step); });
      break;
    case Drag::Window: {
      const auto& volume = mDragScene.volume;
      if (!mHasMoved || !volume.data || volume.data->isColor) break;
      glm::dvec2 window = session::draggedWindow(scene::effectiveWindow(volume), way);
      session::edit(
          mDocument,
          session::ChooseWindow{QString("%1 %2").arg(window.y, 0, 'g', 17).arg(window.x, 0, 'g', 17).toStdString()},
          true);
      break;
    }
    case Drag::None:
      break;
  }
  mDragLast = place;
}

void SectionView::mouseMoveEvent(QMouseEvent* event) {
  if (mToolbox.drag(*this, *event)) {
    if (mToolbox.pausesOtherViews()) emit touched();
    return tellWhatIsAt(event->position());
  }
  if (mDrag != Drag::None) dragTo(toVec(event->position()));
  hover(event->position());
}

void SectionView::endDrag() {
  if (mDrag == Drag::Window) mDocument.endMerge();
  mDrag = Drag::None;
  mDragScene = {};
  unsetCursor();
}

void SectionView::mouseReleaseEvent(QMouseEvent* event) {
  if (mToolbox.release(*this, *event)) return hover(event->position());
  if (event->buttons() != Qt::NoButton || mDrag == Drag::None) return;
  bool wantsMenu = mDrag == Drag::Window && !mHasMoved;
  bool isClick = mDrag == Drag::Crosshair && !mHasMoved;
  endDrag();
  hover(event->position());
  if (isClick || wantsMenu) pickStructure(event->position());
  if (wantsMenu && mSelection.structure() != 0)
    emit structureMenuAsked(mSelection.structure(), event->globalPosition().toPoint());
  else if (wantsMenu)
    showMenu(event->globalPosition().toPoint());
}

void SectionView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || event->modifiers() != Qt::NoModifier) return mousePressEvent(event);
  if (mToolbox.press(*this, *event)) return;
  if (mSincePress.isValid() && !mSincePress.hasExpired(QApplication::doubleClickInterval()))
    change([this](scene::Scene& scene) { scene.sections.crosshair = mCrosshairBefore; });
  emit maximiseWanted();
}

/// A click selects the structure that it meets.
void SectionView::pickStructure(QPointF place) {
  glm::dvec3 world = scene::worldFromSectionPixel(plane(), toVec(place));
  if (mDocument.shown().labels.data) mSelection.setStructure(render::probe(mDocument.shown(), world).structure);
}

/// Says what is under the pointer, and lights the knobs.
void SectionView::hover(QPointF place) {
  std::optional<Qt::CursorShape> grip;
  if (mDrag == Drag::None) grip = mToolbox.hover(*this, place);
  bool onKnob = mDrag == Drag::Turn || (mDrag == Drag::None && !grip && mDocument.shown().sections.showCrosshair &&
                                        session::isOnKnob(session::crosshairLines(mDocument.shown(), mKind, plane()),
                                                          toVec(place), kReachPixels));
  if (onKnob != mHints.hotKnob) {
    mHints.hotKnob = onKnob;
    update();
  }
  if (mDrag == Drag::None) setCursor(grip.value_or(onKnob ? Qt::OpenHandCursor : restCursor()));
  tellWhatIsAt(place);
}

std::optional<render::Pick> SectionView::pickAt(QPointF place) {
  render::Pick pick;
  pick.world = scene::worldFromSectionPixel(plane(), toVec(place));
  render::Probe probe = render::probe(mDocument.shown(), pick.world);
  pick.hit = probe.inside;
  pick.structure = probe.structure;
  if (!probe.values.empty()) pick.value = probe.values.front();
  return pick;
}

void SectionView::tellWhatIsAt(QPointF place) {
  auto pick = pickAt(place);
  if (pick->hit)
    emit pointedAt(*pick);
  else
    emit pointedAtNothing();
}

void SectionView::wheelEvent(QWheelEvent* event) {
  event->accept();
  if (mToolbox.wheel(*this, *event)) return;
  double notches = event->angleDelta().y() / 120.0;
  if (notches == 0.0) return;
  glm::dvec2 place = toVec(event->position());
  bool hasControl = event->modifiers() & Qt::ControlModifier;
  if (hasControl == Preferences::habits().wheelGoesThroughPlanes) {
    change(
        [&](scene::Scene& scene) { scene::zoomSection(scene, mKind, logicalSize(), place, std::pow(0.88, notches)); });
  } else {
    // Whole planes: a fine wheel, or a touch pad, adds up to one.
    mWheelRest += notches;
    double whole = std::trunc(mWheelRest);
    mWheelRest -= whole;
    if (whole != 0.0) scroll(-whole * (event->modifiers() & Qt::ShiftModifier ? kFarSteps : 1.0));
  }
  hover(event->position());
}

void SectionView::keyPressEvent(QKeyEvent* event) {
  double far = event->modifiers() & Qt::ShiftModifier ? kFarSteps : 1.0;
  auto step = [&](double x, double y) {
    change([&](scene::Scene& scene) {
      scene::stepCrosshair(scene, mKind, glm::dvec2(x, y) * far * double(scene::planesPerStep(scene, plane())));
    });
  };
  switch (event->key()) {
    case Qt::Key_Left:
      return step(-1, 0);
    case Qt::Key_Right:
      return step(1, 0);
    case Qt::Key_Up:
      return step(0, 1);
    case Qt::Key_Down:
      return step(0, -1);
    case Qt::Key_PageUp:
      return scroll(-far);
    case Qt::Key_PageDown:
      return scroll(far);
    case Qt::Key_Home:
      return change([](scene::Scene& scene) {
        scene.sections.isPlaced = false;
        scene::placeSections(scene);
      });
    case Qt::Key_F:
      return fit();
    case Qt::Key_R:
      return change(scene::resetSections);
    default:
      QWidget::keyPressEvent(event);
  }
}

bool SectionView::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && isOwnKey(*static_cast<QKeyEvent*>(event))) {
    event->accept();
    return true;
  }
  return QWidget::event(event);
}

void SectionView::contextMenuEvent(QContextMenuEvent* event) {
  // By the mouse it comes when the button is let go, for the same button sets the window.
  if (event->reason() == QContextMenuEvent::Keyboard) showMenu(mapToGlobal(rect().center()));
}

void SectionView::enterEvent(QEnterEvent*) {
  mHints.showKnobs = true;
  for (auto* button : {mMenuButton, mMaximise}) button->setVisible(width() > 4 * button->width());
  update();
}

void SectionView::leaveEvent(QEvent*) {
  mHints.showKnobs = mHints.hotKnob = false;
  mToolbox.leave();
  for (auto* button : {mMenuButton, mMaximise}) button->hide();
  emit pointedAtNothing();
  update();
}

void SectionView::focusInEvent(QFocusEvent*) { update(); }
void SectionView::focusOutEvent(QFocusEvent*) { update(); }

}  // namespace velum::gui
