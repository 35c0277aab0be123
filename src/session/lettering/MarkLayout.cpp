#include "session/lettering/MarkLayout.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/Scene.h"
#include "session/lettering/Leaders.h"
#include "session/lettering/LetteringLayout.h"
#include "session/mark/MarkWords.h"
#include "session/measure/Follow.h"

namespace velum::session {

namespace {

// Lengths, in ems.
constexpr double kTick = 0.42, kDot = 0.17, kHeadLength = 0.95, kHeadWidth = 0.62;
constexpr double kAside = 1.0, kMarkGap = 0.35;
constexpr double kArc = 0.32, kLargestArc = 3.2;  // radius of an angle's arc: of the shorter arm; at most, ems
constexpr double kAreaFill = 0.14;
constexpr int kArcPieces = 24;

glm::dvec2 across(glm::dvec2 v) { return {v.y, -v.x}; }

glm::dvec2 meanOf(const std::vector<glm::dvec2>& points) {
  glm::dvec2 sum(0.0);
  for (glm::dvec2 point : points) sum += point;
  return sum / double(points.size());
}

/// The direction across a line that points up, or to the right where the line is upright.
glm::dvec2 upFrom(glm::dvec2 along) {
  glm::dvec2 out = across(unitOr(along, {1, 0}));
  return out.y > 1e-3 || (std::abs(out.y) <= 1e-3 && out.x < 0.0) ? -out : out;
}

}  // namespace

MarkLayout::MarkLayout(const MarkView& view, const std::map<int, Measured>& measured,
                       const std::vector<SeenPlace>& seen, glm::vec3 ground, double leastEm, FreePlaces& places)
    : mView(view),
      mMeasured(measured),
      mSeen(seen),
      mGround(ground),
      mPlaces(places),
      mStyle(view.scene().lettering, glm::ivec2(view.space().size()), leastEm),
      mLetters(mStyle.font(), mStyle.em()) {}

void MarkLayout::add(const scene::Mark& given) {
  const scene::Mark mark = followed(mView.scene(), given);
  auto seen = std::ranges::find(mSeen, mark.id, &SeenPlace::mark);
  const SeenPlace* place = seen == mSeen.end() ? nullptr : &*seen;
  double opacity = mView.opacityOf(mark) * (place ? place->share : 1.0);
  auto at = mView.pixels(mark.points);
  scene::MarkPoints count = scene::markPoints(mark.kind);
  if (opacity <= 0.0 || !at || at->size() < std::max<std::size_t>(count.least, 1) || at->size() > count.most) return;
  glm::vec3 ink = mark.color.value_or(mStyle.inkOn(mGround));
  mPen = {ink, mStyle.lineWidth(), 1.0, {}};
  mLines = {"marks", {}, LetteringStyle::glowOf(ink, mGround), mStyle.em(), mView.scene().lettering.halo, opacity};
  Measured measured;
  if (auto known = mMeasured.find(mark.id); known != mMeasured.end()) {
    measured = known->second;
  } else if (isMeasuredAtOnce(mark)) {
    Progress progress;
    measured = measure(mView.scene(), given, progress);
  }
  using enum scene::MarkKind;
  if (mView.goesThrough(mark)) return addCrossing(mark, measured);
  switch (mark.kind) {
    case Distance:
      addDistance(mark, *at, measured);
      break;
    case Angle:
      addAngle(mark, *at, measured);
      break;
    case Path:
      addPath(mark, *at, measured);
      break;
    case Area:
      addArea(mark, *at, measured);
      break;
    case Arrow:
      addArrow(mark, *at);
      break;
    case Label:
    case Name:
      addLabel(mark, at->front(), place && place->at ? *place->at : at->front());
      break;
    case Circle:
      addBall(mark, measured);
      break;
    case Box:
      addBox(mark, measured);
      break;
    case Profile:
      addProfile(mark, *at, measured);
      break;
    case Region:
      break;  // stands beside the structure that it measures, see addNames()
  }
  if (!mLines.items.empty()) mBlocks.push_back(std::move(mLines));
}

/// A line that a section cuts is seen where it goes through, and says there nothing of its whole.
void MarkLayout::addCrossing(scene::Mark mark, const Measured& measured) {
  if (measured.way.size() > 1) mark.points = measured.way;
  for (const Pixels& piece : mView.lines(mark)) {
    addLine(piece, false);
    addDot(0.5 * (piece.front() + piece.back()));
  }
  if (!mLines.items.empty()) mBlocks.push_back(std::move(mLines));
}

std::vector<std::string> MarkLayout::linesOf(const scene::Mark& mark, const Measured& measured) const {
  std::string drawn = drawable(markWords(mView.scene(), mark, measured.text));
  return drawn.empty() ? std::vector<std::string>() : mLetters.lines(drawn, 0.4 * mView.space().size().x);
}

MarkLayout::Pixels MarkLayout::wayOf(const Pixels& at, const Measured& measured) const {
  if (measured.way.size() < 2) return at;
  return mView.pixels(measured.way).value_or(at);
}

void MarkLayout::addOutline(vector::Outline outline, double fill) {
  vector::Shape shape{{}, {std::move(outline)}, mPen, {}};
  if (fill > 0.0) shape.fill = vector::Fill{mPen.color, fill};
  mLines.items.push_back(std::move(shape));
}

void MarkLayout::addLine(const Pixels& points, bool isClosed, double fill) {
  addOutline(vector::outlineThrough(points, isClosed), fill);
}

void MarkLayout::addTick(glm::dvec2 end, glm::dvec2 from) {
  glm::dvec2 side = 0.5 * kTick * mStyle.em() * across(unitOr(end - from, {1, 0}));
  addLine({end - side, end + side}, false);
}

void MarkLayout::addDot(glm::dvec2 at) {
  mLines.items.push_back(vector::Shape{
      {}, {vector::circle(at, std::max(kDot * mStyle.em(), mPen.width))}, {}, vector::Fill{mPen.color, 1}});
}

void MarkLayout::addDistance(const scene::Mark& mark, const Pixels& at, const Measured& measured) {
  Pixels way = wayOf(at, measured);
  addLine(way, false);
  addTick(way.front(), way[1]);
  addTick(way.back(), way[way.size() - 2]);
  glm::dvec2 middle = way.size() == 2 ? 0.5 * (at[0] + at[1]) : way[way.size() / 2];
  addWords(mark, {linesOf(mark, measured), middle, kMarkGap * mStyle.em() * upFrom(at[1] - at[0])});
}

/// The arc lies in the plane of the arms.
void MarkLayout::addAngle(const scene::Mark& mark, const Pixels& at, const Measured& measured) {
  addLine(at, false);
  glm::dvec3 vertex = mark.points[1], a = mark.points[0] - vertex, b = mark.points[2] - vertex;
  double la = glm::length(a), lb = glm::length(b);
  if (la <= 0.0 || lb <= 0.0) return;
  a /= la, b /= lb;
  double radius = std::min(kArc * std::min(la, lb), kLargestArc * mStyle.em() * mView.space().lengthPerPixel(vertex));
  double angle = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
  glm::dvec3 side = b - a * glm::dot(a, b);
  std::vector<glm::dvec3> arc;
  for (int i = 0; i <= kArcPieces && glm::length(side) > 1e-9; ++i) {
    double t = angle * i / kArcPieces;
    arc.push_back(vertex + radius * (a * std::cos(t) + glm::normalize(side) * std::sin(t)));
  }
  auto pixels = mView.pixels(arc);
  glm::dvec2 middle = at[1], out(0, -1);
  if (pixels && !pixels->empty()) {
    addLine(*pixels, false);
    middle = (*pixels)[pixels->size() / 2];
    out = unitOr(middle - at[1], out);
  }
  addWords(mark, {linesOf(mark, measured), middle, kMarkGap * mStyle.em() * out});
}

void MarkLayout::addPath(const scene::Mark& mark, const Pixels& at, const Measured& measured) {
  Pixels way = wayOf(at, measured);
  addLine(way, false);
  for (glm::dvec2 point : at) addDot(point);
  glm::dvec2 out = unitOr(at.back() - at[at.size() - 2], {1, 0});
  addWords(mark, {linesOf(mark, measured), at.back(), kAside * mStyle.em() * out});
}

void MarkLayout::addArea(const scene::Mark& mark, const Pixels& at, const Measured& measured) {
  addLine(at, true, kAreaFill);
  addWords(mark, {linesOf(mark, measured), meanOf(at), {}});
}

void MarkLayout::addArrow(const scene::Mark& mark, const Pixels& at) {
  double em = mStyle.em(), length = glm::distance(at[0], at[1]);
  glm::dvec2 along = unitOr(at[1] - at[0], {1, 0}), side = 0.5 * kHeadWidth * em * across(along);
  glm::dvec2 neck = at[1] - along * std::min(kHeadLength * em, length);
  addLine({at[0], neck}, false);
  vector::Shape head{{}, {vector::outlineThrough({at[1], neck + side, neck - side}, true)}, {}, {}};
  head.fill = vector::Fill{mPen.color, 1.0};
  mLines.items.push_back(std::move(head));
  addWords(mark, {linesOf(mark, {}), at[0], -kMarkGap * em * along});
}

void MarkLayout::addBall(const scene::Mark& mark, const Measured& measured) {
  if (mark.normal != glm::dvec3(0.0)) return addCircle(mark, measured);
  auto seen = mView.space().circleOfBall(mark.points[0], glm::distance(mark.points[0], mark.points[1]));
  if (!seen || seen->radius <= 0.0) return;
  addOutline(vector::circle(seen->middle, seen->radius));
  glm::dvec2 out = glm::normalize(glm::dvec2(1.0, -0.55));
  addWords(mark, {linesOf(mark, measured), seen->middle + seen->radius * out, kMarkGap * mStyle.em() * out});
}

void MarkLayout::addCircle(const scene::Mark& mark, const Measured& measured) {
  auto places = mView.pixels(circlePlaces(mark));
  if (!places) return;
  places->pop_back();
  addLine(*places, true);
  glm::dvec2 right = *std::ranges::max_element(*places, {}, [](glm::dvec2 p) { return p.x - 0.55 * p.y; });
  addWords(mark, {linesOf(mark, measured), right, kMarkGap * mStyle.em() * glm::normalize(glm::dvec2(1.0, -0.55))});
}

/// Its twelve edges, or where the section cuts it.
void MarkLayout::addBox(const scene::Mark& mark, const Measured& measured) {
  std::vector<glm::dvec3> corners = boxCorners(mView.scene(), mark);
  auto at = mView.pixels(corners);
  if (!at) return;
  Pixels outline;
  for (int corner = 0; corner < 8; ++corner)
    for (int axis = 1; axis < 8; axis *= 2) {
      if (corner & axis) continue;
      std::size_t from = std::size_t(corner), to = std::size_t(corner | axis);
      if (!mView.isSection()) {
        addLine({(*at)[from], (*at)[to]}, false);
        continue;
      }
      double a = mView.height(corners[from]), b = mView.height(corners[to]);
      if ((a < 0.0) != (b < 0.0)) outline.push_back(glm::mix((*at)[from], (*at)[to], a / (a - b)));
    }
  // A box that lies in the section, or just beside it, is seen as its face.
  if (mView.isSection() && outline.size() < 3) outline = *at;
  glm::dvec2 middle = meanOf(*at), high(-1e9), low(1e9);
  if (mView.isSection()) {
    middle = meanOf(outline);
    auto angleOf = [&](glm::dvec2 point) { return std::atan2(point.y - middle.y, point.x - middle.x); };
    std::ranges::sort(outline, {}, angleOf);
    std::erase_if(outline,
                  [&](const glm::dvec2& point) { return &point != &outline.front() && point == *(&point - 1); });
    addLine(outline, true);
  }
  for (glm::dvec2 point : mView.isSection() ? outline : *at) high = glm::max(high, point), low = glm::min(low, point);
  addWords(mark, {linesOf(mark, measured), {high.x, 0.5 * (low.y + high.y)}, {kMarkGap * mStyle.em(), 0.0}});
}

void MarkLayout::addProfile(const scene::Mark& mark, const Pixels& at, const Measured& measured) {
  addLine(at, false);
  addTick(at[0], at[1]);
  addDot(at[1]);
  addPlot(mark, at[1], measured);
}

}  // namespace velum::session
