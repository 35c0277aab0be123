#include "gui/mark/MarkGrips.h"

#include <utility>

#include "gui/kit/Points.h"
#include "gui/kit/Theme.h"
#include "gui/kit/Words.h"
#include "gui/mark/MarkTool.h"
#include "gui/tool/HandlePaint.h"
#include "session/command/Command.h"
#include "session/mark/MarkWords.h"
#include "session/measure/Follow.h"

namespace velum::gui {

namespace {

constexpr double kMarkReach = 9.0, kMarkStillPixels = 3.0;
constexpr double kFineStep = 1.0, kFarStep = 10.0;  // of the arrow keys, pixels

using session::MarkGrip, session::MarkPart;

/// Which way an arrow key goes on the screen.
QPointF arrowWay(int key) {
  return {double(key == Qt::Key_Right) - double(key == Qt::Key_Left),
          double(key == Qt::Key_Down) - double(key == Qt::Key_Up)};
}

const char* markStepOf(MarkPart part) {
  return part == MarkPart::Words ? "Move words of mark" : part == MarkPart::Line ? "Move mark" : "Move point of mark";
}

}  // namespace

MarkGrips::MarkGrips(session::Document& document, Selection& selection, Toolbox& toolbox,
                     const LetteringOverlay& lettering, QObject* parent)
    : QObject(parent), mDocument(document), mSelection(selection), mToolbox(toolbox), mLettering(lettering) {
  connect(&selection, &Selection::markChanged, this, [this] {
    if (mHeld.part == MarkPart::None) choosePoint(-1);  // what is dragged stays one step
  });
}

MarkGrip MarkGrips::gripUnder(const ViewPoint& at) const {
  const scene::Scene& scene = mDocument.shown();
  session::MarkReach reach{.reach = kMarkReach, .step = scene::sectionStep(scene), .selected = mSelection.mark()};
  reach.words = mLettering.words(at.view());
  MarkGrip grip = session::markAt(scene, at.space(), at.pixel(), reach);
  // A name that has found its place by itself is taken hold of as the words of a mark.
  if (grip.part == MarkPart::None && wordsUnder(at, 0)) return {MarkPart::Words, 0, 0};
  return grip;
}

const session::PlacedWords* MarkGrips::wordsUnder(const ViewPoint& at, int mark) const {
  for (const session::PlacedWords& words : mLettering.words(at.view())) {
    bool isOver =
        glm::all(glm::greaterThanEqual(at.pixel(), words.low)) && glm::all(glm::lessThanEqual(at.pixel(), words.high));
    if (isOver && words.mark == mark) return &words;
  }
  return nullptr;
}

/// Makes a mark of a name that is dragged: from now on it stands where the hand puts it.
void MarkGrips::takeName(const session::PlacedWords& name) {
  int id = 0;
  session::editByHand(
      mDocument, markStepOf(MarkPart::Words),
      [&](scene::Scene& scene) {
        if (scene.lettering.marks.size() < scene::kMostMarks)
          id = scene::addMark(scene.lettering.marks, session::markOfName(name));
      },
      true);
  mHeld.mark = id;
  mSelection.setMark(id);
  if (const scene::Mark* mark = selected()) mStart = *mark;
}

bool MarkGrips::holds(const ViewPoint& at) const {
  MarkPart part = gripUnder(at).part;
  return part == MarkPart::Point || part == MarkPart::Words;
}

const MarkTool* MarkGrips::tool() const { return qobject_cast<const MarkTool*>(mToolbox.active()); }

/// A tool sets the points of a mark: its clicks are no business of others.
bool MarkGrips::isSetting() const { return tool() && tool()->isSetting(); }

void MarkGrips::setHover(MarkGrip grip) {
  if (std::exchange(mHover, grip) != grip) mToolbox.repaint();
}

void MarkGrips::choosePoint(int point) {
  mDocument.endMerge();
  mPoint = point;
  mToolbox.repaint();
}

void MarkGrips::refresh() {
  const scene::Mark* mark = selected();
  if (!mark && mSelection.mark() != 0) mSelection.setMark(0);
  if (mark && mPoint >= int(mark->points.size())) mPoint = -1;
}

bool MarkGrips::press(const PointerEvent& event) {
  bool isLeft = event.button == Qt::LeftButton, isRight = event.button == Qt::RightButton;
  if ((!isLeft && !isRight) || event.keys != Qt::NoModifier || isSetting()) return false;
  MarkGrip grip = gripUnder(event.at);
  bool isForTool = grip.part == MarkPart::Line && tool();  // a mark may begin on the line of another
  if (grip.part == MarkPart::None || isForTool) {
    if (mPoint >= 0) choosePoint(-1);  // from now on arrows do what they do elsewhere
    return false;
  }
  if (grip.mark == 0 && isRight) return false;
  mSelection.setMark(grip.mark);
  if (grip.part == MarkPart::Words) mWords = *wordsUnder(event.at, grip.mark);
  if (grip.part == MarkPart::Line && isLeft && !event.at.isOnSection()) return false;  // the drag turns the camera
  choosePoint(grip.part == MarkPart::Point ? int(grip.point) : -1);
  mHeld = mHover = grip;
  if (selected())
    mStart = grip.part == MarkPart::Words ? *selected() : session::followed(mDocument.shown(), *selected());
  mStartSpace = event.at.space();
  mFrom = event.at.pixel();
  mView = &event.at.view();
  mPointer = event.at.place();
  mWantsMenu = isRight;
  mHasMoved = false;
  return true;
}

void MarkGrips::drag(const PointerEvent& event) {
  glm::dvec2 way = event.at.pixel() - mFrom;
  mHasMoved = mHasMoved || glm::length(way) > kMarkStillPixels;
  if (mHasMoved && mHeld == MarkGrip{MarkPart::Words, 0, 0}) takeName(mWords);
  // What is dragged may have been undone meanwhile.
  if (!mHasMoved || mWantsMenu || !selected() || mHeld.mark != mSelection.mark()) return;
  mPointer = event.at.place();
  const scene::SectionPlane* section = mStartSpace.section();
  scene::Mark now = mStart;
  if (mHeld.part == MarkPart::Words) {
    now = session::withWordsBy(mStart, mWords, way, mStartSpace);
  } else if (mHeld.part == MarkPart::Line && section) {
    for (glm::dvec3& p : now.points)
      p += scene::worldFromSectionPixel(*section, way) - scene::worldFromSectionPixel(*section, glm::dvec2(0.0));
    now.pointInstances.clear();
    now.pointStructures.clear();
  } else if (mHeld.part == MarkPart::Point) {
    // In the section plane in which the point was taken; in the picture on what is seen, where something is.
    auto seen = mStartSpace.pixelFromWorld(mStart.points[mHeld.point]);
    auto to = section && seen ? std::optional(scene::worldFromSectionPixel(*section, *seen + way)) : event.at.world();
    if (to) {
      const render::Pick* pick = !section && event.at.pick() ? &*event.at.pick() : nullptr;
      session::MarkAim aim = session::aimOf(mDocument.shown(), event.at.space(), event.at.pixel(), *to, pick);
      now = session::withPointAt(mStart, mHeld.point, aim.place, mStartSpace, aim.instance);
    }
  }
  place(now, markStepOf(mHeld.part));
}

void MarkGrips::place(const scene::Mark& mark, const char* step) {
  if (const scene::Mark* before = selected(); !before || *before == mark) return;
  session::editByHand(
      mDocument, step,
      [&](scene::Scene& scene) {
        if (scene::Mark* found = session::findMark(scene, mark.id)) *found = mark;
      },
      true);
  mToolbox.repaint();
}

void MarkGrips::release(const PointerEvent& event) {
  bool wantsMenu = std::exchange(mWantsMenu, false) && !mHasMoved;
  mHeld = {};
  mView = nullptr;
  mDocument.endMerge();
  mToolbox.repaint();
  if (wantsMenu && selected()) emit menuAsked(mSelection.mark(), event.globalPlace);
}

std::optional<Qt::CursorShape> MarkGrips::hover(const ViewPoint& at) {
  MarkGrip grip = isSetting() ? MarkGrip{} : gripUnder(at);
  setHover(grip);
  if (grip.part == MarkPart::None) return std::nullopt;
  return grip.part == MarkPart::Line && !at.isOnSection() ? Qt::PointingHandCursor : Qt::SizeAllCursor;
}

/// Moves the selected point as far as an arrow key says.
void MarkGrips::step(ToolView& view, QPointF way) {
  if (!selected() || mPoint < 0) return;
  session::ViewSpace space = view.space();
  scene::Mark mark = session::followed(mDocument.shown(), *selected());
  auto seen = space.pixelFromWorld(mark.points[std::size_t(mPoint)]);
  if (!seen) return;
  ViewPoint at(view, mDocument.shown(), toPoint(*seen) + way);
  if (auto to = at.world()) place(session::withPointAt(mark, std::size_t(mPoint), *to, space), "Move point of mark");
}

KeyAnswer MarkGrips::key(const KeyStroke& stroke) {
  const scene::Mark* mark = selected();
  if (!mark || !stroke.view || isSetting()) return {};
  bool hasShift = stroke.keys & Qt::ShiftModifier;
  if (stroke.keys & ~(Qt::ShiftModifier | Qt::KeypadModifier)) return {};
  if (stroke.key == Qt::Key_Delete) return [this, id = mark->id] { emit removeAsked(id); };
  if (stroke.key == Qt::Key_Escape) return [this] { mPoint >= 0 ? choosePoint(-1) : mSelection.setMark(0); };
  // Behind the last point, and before the first one, Tab leaves the view as ever.
  bool isBack = stroke.key == Qt::Key_Backtab;
  if (stroke.key == Qt::Key_Tab || isBack) {
    int next = isBack ? (mPoint < 0 ? -1 : mPoint - 1) : mPoint + 1;
    if (next < 0 || next >= int(mark->points.size())) return {};
    return [this, next] { choosePoint(next); };
  }
  QPointF way = arrowWay(stroke.key);
  if (mPoint < 0 || way.isNull()) return {};
  return [this, view = stroke.view, way = way * (hasShift ? kFarStep : kFineStep)] { step(*view, way); };
}

void MarkGrips::paint(ViewPainter& over) const {
  const scene::Scene& scene = mDocument.shown();
  double nearby = scene::sectionStep(scene);
  for (const scene::Mark& given : scene.lettering.marks) {
    bool isSelected = given.id == mSelection.mark(), isHot = given.id == mHover.mark;
    if (!session::isShown(scene, given) || (!isSelected && !isHot)) continue;
    const scene::Mark mark = session::followed(scene, given);
    for (std::size_t i = 0; i < mark.points.size(); ++i) {
      auto pixel = over.space.pixelFromWorld(mark.points[i]);
      double share = session::pointShare(over.space, mark, i, nearby);
      if (!pixel || share <= 0.0) continue;
      bool isHotPoint = mHover == MarkGrip{MarkPart::Point, mark.id, i} || (isSelected && int(i) == mPoint);
      over.painter.setOpacity(share);
      drawKnob(over.painter, toPoint(*pixel), isHotPoint);
    }
    over.painter.setOpacity(1.0);
  }
  if (&over.view != mView || !mHasMoved || mHeld.part == MarkPart::Words || !selected()) return;
  drawTag(over.painter, mPointer, over.size, localNumber(session::markValue(scene, *selected())));
}

}  // namespace velum::gui
