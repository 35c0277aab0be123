#include "gui/mark/MarkTool.h"

#include <algorithm>

#include "core/Error.h"
#include "gui/kit/CoreWords.h"
#include "gui/kit/Theme.h"
#include "gui/kit/Words.h"
#include "gui/mark/MarkGrips.h"
#include "gui/tool/HandlePaint.h"
#include "scene/ModelLayer.h"
#include "session/command/Command.h"
#include "session/command/MarkCommands.h"
#include "session/command/StructureCommands.h"
#include "session/mark/MarkHands.h"
#include "session/mark/MarkWords.h"
#include "session/model/ModelEdit.h"

namespace velum::gui {

namespace {

/// A click so near to the last point, or to the first of an area, ends a mark of many points.
constexpr double kEndPixels = 5.0;

using scene::MarkKind;

bool isNearPlace(const session::ViewSpace& space, glm::dvec3 place, glm::dvec2 pixel) {
  auto seen = space.pixelFromWorld(place);
  return seen && glm::distance(*seen, pixel) <= kEndPixels;
}

}  // namespace

MarkTool::MarkTool(MarkKind kind, const WindowParts& parts, const MarkGrips& grips)
    : mKind(kind),
      mDocument(parts.document()),
      mSelection(parts.selection),
      mToolbox(parts.toolbox),
      mMessages(parts.messages),
      mGrips(grips) {}

void MarkTool::say(const QString& text) {
  mHint = text;
  mToolbox.repaint();
}

QString MarkTool::whatIsNext() const {
  bool isFirst = mPoints.empty();
  switch (mKind) {
    case MarkKind::Angle:
      return isFirst               ? tr("Click a point of the angle's first leg. Esc ends.")
             : mPoints.size() == 1 ? tr("Click where the legs meet. Backspace takes a point back.")
                                   : tr("Click a point of the second leg. Backspace takes a point back.");
    case MarkKind::Path:
      if (isFirst) return tr("Click the first point of the way. Esc ends.");
      return tr("Click the next point; a double click or Enter ends the way. Backspace takes a point back.");
    case MarkKind::Area:
      if (isFirst) return tr("Click the first corner. Esc ends.");
      return tr("Click the next corner; a double click, Enter or the first corner closes the area.");
    case MarkKind::Arrow:
      return isFirst ? tr("Click where the arrow begins. Esc ends.") : tr("Click what it points at.");
    case MarkKind::Label:
      return tr("Click the place that the words belong to. Esc ends.");
    case MarkKind::Name:
      return tr("Click a structure or a molecule to name it. Esc ends.");
    case MarkKind::Circle:
      return isFirst ? tr("Click the middle of the circle. Esc ends.") : tr("Click its rim.");
    case MarkKind::Box:
      return isFirst ? tr("Click a corner of the box. Esc ends.") : tr("Click the corner across.");
    default:
      return isFirst ? tr("Click the first of two points. Esc ends.")
                     : tr("Click the second point. Backspace takes the first one back.");
  }
}

void MarkTool::clear() {
  mPoints.clear();
  mInstances.clear();
}

bool MarkTool::start() {
  clear();
  mNext.reset();
  say(whatIsNext());
  return true;
}

bool MarkTool::press(const PointerEvent& event) {
  return !(mPoints.empty() && mGrips.holds(event.at)) && ClickTool::press(event);
}

bool MarkTool::endsAt(const PointerEvent& event) const {
  if (!takesMore() || mPoints.empty()) return false;
  bool isAtFirst = mKind == MarkKind::Area && isNearPlace(event.at.space(), mPoints.front(), event.at.pixel());
  return isAtFirst || isNearPlace(event.at.space(), mPoints.back(), event.at.pixel());
}

void MarkTool::click(const PointerEvent& event) {
  if (event.keys != Qt::NoModifier) return;
  if (mKind == MarkKind::Name) return name(event);
  auto aim = aimAt(event.at);
  if (!aim) return say(tr("Nothing is there: click on what is drawn. %1").arg(whatIsNext()));
  if (endsAt(event)) {
    if (isComplete()) finish(event.at.space());
    return;
  }
  mPoints.push_back(aim->place);
  mInstances.push_back(aim->instance);
  mPick = event.at.pick();
  mSpace = event.at.space();
  mView = &event.at.view();
  mPlace = event.at.place();
  mNext = aim->place;
  if (mPoints.size() == scene::markPoints(mKind).most) return finish(mSpace);
  say(whatIsNext());
}

/// The structure, or the type of the molecule, that is seen there.
void MarkTool::name(const PointerEvent& event) {
  const scene::Scene& scene = mDocument.shown();
  const auto& pick = event.at.pick();
  if (!pick || (pick->structure == 0 && pick->type < 0))
    return say(tr("Nothing there has a name. %1").arg(whatIsNext()));
  scene::Mark mark{.kind = MarkKind::Name, .points = {pick->world}};
  if (pick->type >= 0) {
    mark.type = pathOf(*scene.model.data, scene.model.data->types[std::size_t(pick->type)]);
    if (auto place = session::instancePlace(scene, pick->modelInstance)) {
      mark.points[0] = place->middle;
      mark.pointInstances = {int(pick->modelInstance)};
    }
  } else {
    mark.structure = pick->structure;
  }
  add(mark);
}

void MarkTool::finish(const session::ViewSpace& space) {
  double step = scene::sectionStep(mDocument.shown());
  scene::Mark mark = session::markOfClicks(mKind, mPoints, space, step);
  bool follows = std::ranges::any_of(mInstances, [](int instance) { return instance >= 0; });
  if (follows) mark.pointInstances = mInstances;
  clear();
  if (mKind == MarkKind::Label) pointAtWhatIsSeen(mark);
  add(mark);
}

/// In the picture a label belongs to the structure or molecule that is clicked.
void MarkTool::pointAtWhatIsSeen(scene::Mark& mark) const {
  const scene::Scene& scene = mDocument.shown();
  if (!mPick || mSpace.section()) return;
  if (mPick->type >= 0)
    mark.type = pathOf(*scene.model.data, scene.model.data->types[std::size_t(mPick->type)]);
  else
    mark.structure = mPick->structure;
}

/// What a click takes: the middle of a molecule near it, else the place that is seen.
std::optional<session::MarkAim> MarkTool::aimAt(const ViewPoint& at) const {
  auto place = at.world();
  if (!place) return std::nullopt;
  bool mayFollow = mDocument.shown().model.data && !at.isOnSection() && at.pick();
  return session::aimOf(mDocument.shown(), at.space(), at.pixel(), *place, mayFollow ? &*at.pick() : nullptr);
}

void MarkTool::add(scene::Mark mark) {
  const scene::Scene& scene = mDocument.shown();
  int id = scene::nextId(scene.lettering.marks);
  session::AddMark call{mark.kind, mark.points, mark.text, {}, mark.type};
  call.pointInstances = mark.pointInstances;
  call.normal = mark.normal;
  if (mark.structure != 0) call.structure = session::structureNames(scene, {mark.structure})[0];
  if (mKind == MarkKind::Label) call.text = "Label";
  try {
    session::edit(mDocument, call);
  } catch (const Error& error) {
    return mMessages.showError(inWords(error.what()));
  }
  mNext.reset();
  say(whatIsNext());
  emit made(id);
}

std::optional<Qt::CursorShape> MarkTool::hover(const ViewPoint& at) {
  if (!mPoints.empty()) {
    auto aim = aimAt(at);
    mNext = aim ? std::optional(aim->place) : std::nullopt;
    mView = &at.view();
    mPlace = at.place();
    mToolbox.repaint();
  } else if (mGrips.holds(at)) {
    return std::nullopt;
  }
  return Qt::CrossCursor;
}

void MarkTool::leave() {
  if (!mView) return;
  mView = nullptr;
  mNext.reset();
  mToolbox.repaint();
}

void MarkTool::takeBack() {
  mPoints.pop_back();
  mInstances.pop_back();
  say(whatIsNext());
}

KeyAnswer MarkTool::key(const KeyStroke& stroke) {
  if (stroke.isTyping || stroke.keys & ~Qt::KeypadModifier || mPoints.empty()) return {};
  if (stroke.key == Qt::Key_Backspace) return [this] { takeBack(); };
  bool isEnter = stroke.key == Qt::Key_Return || stroke.key == Qt::Key_Enter;
  if (isEnter && takesMore() && isComplete()) return [this] { finish(mSpace); };
  return {};
}

void MarkTool::paint(ViewPainter& over) const {
  if (mPoints.empty()) return;
  const scene::Scene& scene = mDocument.shown();
  scene::Mark mark{.kind = mKind, .points = mPoints};
  if (mNext) mark.points.push_back(*mNext);
  QString value = localNumber(session::markValue(scene, mark));
  scene::Mark lines = mark;
  lines.kind = mark.points.size() < scene::markPoints(mKind).least ? MarkKind::Path : mKind;
  for (const auto& line : session::markLines(over.space, lines, scene::sectionStep(scene))) {
    QPainterPath path;
    for (const glm::dvec2& p : line) path.elementCount() == 0 ? path.moveTo(p.x, p.y) : path.lineTo(p.x, p.y);
    strokeTwice(over.painter, path, kHandle, 1.5);
  }
  for (std::size_t i = 0; i < mPoints.size(); ++i) {
    auto pixel = over.space.pixelFromWorld(mPoints[i]);
    bool isHere = session::pointShare(over.space, mark, i, scene::sectionStep(scene)) > 0.0;
    if (pixel && isHere) drawKnob(over.painter, QPointF(pixel->x, pixel->y), false);
  }
  if (&over.view == mView && mNext) drawTag(over.painter, mPlace, over.size, value);
}

}  // namespace velum::gui
