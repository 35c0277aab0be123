#include "session/mark/MarkHands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <tuple>
#include <utility>

#include "scene/Project.h"
#include "session/measure/Follow.h"
#include "session/model/ModelEdit.h"

namespace velum::session {

namespace {

using scene::Mark;
using scene::MarkKind;
using Line = std::vector<glm::dvec2>;

constexpr double kWordsReach = 2.0;   ///< around words, pixels
constexpr double kSnapPixels = 12.0;  ///< so near to its middle an instance draws a point to itself
constexpr std::size_t kCircleParts = 72;
constexpr double kSeenSteps = 1.5;  ///< so far beside a section a mark is seen there, steps

double shareAt(double height, double step) { return std::clamp(kSeenSteps - std::abs(height) / step, 0.0, 1.0); }

/// The stretch of a way from one height to another that is nowhere farther from 0, as shares of the way; empty where
/// the first is larger than the second.
glm::dvec2 stretchWithin(double from, double to, double farthest) {
  glm::dvec2 stretch(0.0, 1.0);
  for (double sign : {1.0, -1.0}) {
    double a = farthest - sign * from, b = farthest - sign * to;  // what is left up to the border
    if (a < 0.0 && b < 0.0) return {1.0, 0.0};
    if (a < 0.0) stretch.x = std::max(stretch.x, a / (a - b));
    if (b < 0.0) stretch.y = std::min(stretch.y, a / (a - b));
  }
  return stretch;
}

/// Of a line through places, what is seen: on a section what lies in it, or no farther beside it than marks are seen.
std::vector<Line> seenLines(const ViewSpace& view, const std::vector<glm::dvec3>& places, double step) {
  const scene::SectionPlane* plane = view.section();
  std::vector<Line> lines;
  Line line;
  auto end = [&] {
    if (line.size() > 1) lines.push_back(line);
    line.clear();
  };
  for (std::size_t i = 1; i < places.size(); ++i) {
    const glm::dvec3 &a = places[i - 1], &b = places[i];
    glm::dvec2 seen(0.0, 1.0);
    if (plane)
      seen = stretchWithin(scene::heightOverSection(*plane, a), scene::heightOverSection(*plane, b), kSeenSteps * step);
    auto from = view.pixelFromWorld(glm::mix(a, b, seen.x)), to = view.pixelFromWorld(glm::mix(a, b, seen.y));
    bool isSeen = seen.x < seen.y && from && to;
    if (!isSeen || seen.x > 0.0) end();
    if (!isSeen) continue;
    if (line.empty()) line.push_back(*from);
    line.push_back(*to);
    if (seen.y < 1.0) end();
  }
  end();
  return lines;
}

/// The stretch of heights over a section that a mark takes.
glm::dvec2 heightsOf(const scene::SectionPlane& plane, const Mark& mark) {
  glm::dvec2 heights(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
  auto take = [&](double height) { heights = {std::min(heights.x, height), std::max(heights.y, height)}; };
  for (const glm::dvec3& p : mark.points) take(scene::heightOverSection(plane, p));
  if (mark.kind == MarkKind::Circle && mark.points.size() == 2 && mark.normal == glm::dvec3(0.0)) {
    double radius = glm::distance(mark.points[0], mark.points[1]);
    double middle = scene::heightOverSection(plane, mark.points[0]);
    take(middle - radius), take(middle + radius);
  }
  return heights;
}

double heightFrom(glm::dvec2 stretch) { return stretch.x > 0.0 ? stretch.x : stretch.y < 0.0 ? stretch.y : 0.0; }

Line circle(ViewCircle circle) {
  Line line;
  for (int i = 0; i <= int(kCircleParts); ++i) {
    double angle = 2.0 * glm::pi<double>() * i / double(kCircleParts);
    line.push_back(circle.middle + circle.radius * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
  return line;
}

/// The edges of a box along the volume's axes; on a section those that lie across its normal, in front.
std::vector<Line> boxLines(const ViewSpace& view, glm::dvec3 a, glm::dvec3 b) {
  std::vector<Line> lines;
  for (int corner = 0; corner < 8; ++corner)
    for (int axis = 0; axis < 3; ++axis) {
      if (corner >> axis & 1) continue;
      auto at = [&](int which) {
        return glm::dvec3(which & 1 ? b.x : a.x, which & 2 ? b.y : a.y, which & 4 ? b.z : a.z);
      };
      glm::dvec3 from = at(corner), to = at(corner | 1 << axis);
      auto p = view.pixelFromWorld(from), q = view.pixelFromWorld(to);
      if (p && q) lines.push_back({*p, *q});
    }
  return lines;
}

double distanceToLine(const Line& line, glm::dvec2 pixel) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < line.size(); ++i) {
    glm::dvec2 along = line[i] - line[i - 1];
    double square = glm::dot(along, along);
    double t = square > 0.0 ? std::clamp(glm::dot(pixel - line[i - 1], along) / square, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, glm::distance(pixel, line[i - 1] + t * along));
  }
  return nearest;
}

bool areWordsOf(const MarkReach& reach, int mark, glm::dvec2 pixel) {
  return std::ranges::any_of(reach.words, [&](const PlacedWords& words) {
    return words.mark == mark && glm::all(glm::greaterThanEqual(pixel, words.low - kWordsReach)) &&
           glm::all(glm::lessThanEqual(pixel, words.high + kWordsReach));
  });
}

/// The grip of a part of one mark with its distance from the pixel; the part None where nothing is within reach.
std::pair<MarkGrip, double> gripOf(const Mark& mark, const ViewSpace& view, glm::dvec2 pixel, const MarkReach& reach) {
  std::pair<MarkGrip, double> best{{}, reach.reach};
  for (std::size_t i = 0; i < mark.points.size(); ++i) {
    auto place = view.pixelFromWorld(mark.points[i]);
    if (!place || pointShare(view, mark, i, reach.step) <= 0.0) continue;
    if (double away = glm::distance(*place, pixel); away <= best.second) best = {{MarkPart::Point, mark.id, i}, away};
  }
  if (best.first.part != MarkPart::None) return best;
  if (areWordsOf(reach, mark.id, pixel)) return {{MarkPart::Words, mark.id, 0}, 0.0};
  for (const Line& line : markLines(view, mark, reach.step))
    if (double away = distanceToLine(line, pixel); away <= 0.5 * best.second)
      best = {{MarkPart::Line, mark.id, 0}, 2.0 * away};
  return best;
}

void dropTrailing(std::vector<int>& items, int none) {
  while (!items.empty() && items.back() == none) items.pop_back();
}

int rankOf(MarkPart part) { return part == MarkPart::None ? 9 : static_cast<int>(part); }

}  // namespace

bool isShown(const scene::Scene& scene, const Mark& mark) {
  return mark.visible && (mark.timeStep < 0 || mark.timeStep == scene.volume.timeStep);
}

double markShare(const ViewSpace& view, const Mark& mark, double step) {
  const scene::SectionPlane* plane = view.section();
  if (!plane || mark.points.empty()) return 1.0;
  return shareAt(heightFrom(heightsOf(*plane, mark)), step);
}

double pointShare(const ViewSpace& view, const Mark& mark, std::size_t point, double step) {
  const scene::SectionPlane* plane = view.section();
  if (!plane) return 1.0;
  bool isSolid = mark.kind == MarkKind::Box || (mark.kind == MarkKind::Circle && mark.normal == glm::dvec3(0.0));
  if (isSolid) return markShare(view, mark, step);
  return shareAt(scene::heightOverSection(*plane, mark.points[point]), step);
}

std::vector<Line> markLines(const ViewSpace& view, const Mark& mark, double step) {
  if (mark.points.size() < 2) return {};
  if (mark.kind == MarkKind::Circle && mark.normal != glm::dvec3(0.0)) return seenLines(view, circlePlaces(mark), step);
  if (mark.kind == MarkKind::Circle) {
    auto round = view.circleOfBall(mark.points[0], glm::distance(mark.points[0], mark.points[1]));
    return round ? std::vector<Line>{circle(*round)} : std::vector<Line>();
  }
  if (mark.kind == MarkKind::Box) return boxLines(view, mark.points[0], mark.points[1]);
  std::vector<glm::dvec3> places = mark.points;
  if (mark.kind == MarkKind::Area) places.push_back(places.front());
  return seenLines(view, places, step);
}

bool goesThrough(const ViewSpace& view, const Mark& mark, double step) {
  bool isLine = mark.points.size() > 1 && mark.kind != MarkKind::Box && mark.kind != MarkKind::Region &&
                (mark.kind != MarkKind::Circle || mark.normal != glm::dvec3(0.0));
  if (!view.section() || !isLine) return false;
  for (std::size_t i = 0; i < mark.points.size(); ++i)
    if (pointShare(view, mark, i, step) <= 0.0) return true;
  return false;
}

std::vector<glm::dvec3> circlePlaces(const Mark& mark) {
  glm::dvec3 normal = glm::normalize(mark.normal), rim = mark.points[1] - mark.points[0];
  double radius = glm::length(rim);
  glm::dvec3 x = rim - normal * glm::dot(rim, normal);
  if (glm::length(x) <= 1e-9 * radius)
    x = glm::cross(normal, std::abs(normal.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0));
  x = glm::normalize(x);
  glm::dvec3 y = glm::cross(normal, x);
  std::vector<glm::dvec3> places;
  for (int i = 0; i <= int(kCircleParts); ++i) {
    double angle = 2.0 * glm::pi<double>() * i / double(kCircleParts);
    places.push_back(mark.points[0] + radius * (x * std::cos(angle) + y * std::sin(angle)));
  }
  return places;
}

MarkGrip markAt(const scene::Scene& scene, const ViewSpace& view, glm::dvec2 pixel, const MarkReach& reach) {
  MarkGrip best;
  auto key = [&](const MarkGrip& grip, double away) {
    return std::tuple(rankOf(grip.part), grip.mark != reach.selected, away);
  };
  auto bestKey = key(best, 0.0);
  for (const Mark& given : scene.lettering.marks) {
    if (!isShown(scene, given)) continue;
    const Mark mark = followed(scene, given);
    if (markShare(view, mark, reach.step) <= 0.0) continue;
    auto [grip, away] = gripOf(mark, view, pixel, reach);
    if (grip.part == MarkPart::None || key(grip, away) >= bestKey) continue;
    best = grip;
    bestKey = key(grip, away);
  }
  return best;
}

Mark withPointAt(Mark mark, std::size_t point, glm::dvec3 place, const ViewSpace& view, int instance) {
  if (point >= mark.points.size()) return mark;
  glm::dvec3 before = mark.points[point];
  if (const auto* plane = view.section(); plane && mark.kind == MarkKind::Box)
    place += plane->normal * (scene::heightOverSection(*plane, before) - scene::heightOverSection(*plane, place));
  mark.points[point] = place;
  if (mark.kind == MarkKind::Circle && point == 0) mark.points[1] += place - before;
  if (point < mark.pointStructures.size()) mark.pointStructures[point] = 0;
  if (instance >= 0 && point >= mark.pointInstances.size()) mark.pointInstances.resize(point + 1, -1);
  if (point < mark.pointInstances.size()) mark.pointInstances[point] = instance;
  dropTrailing(mark.pointStructures, 0);
  dropTrailing(mark.pointInstances, -1);
  return mark;
}

MarkAim aimOf(const scene::Scene& scene, const ViewSpace& view, glm::dvec2 pixel, glm::dvec3 place,
              const render::Pick* pick) {
  auto instance = pick && pick->type >= 0 && !view.section() ? instancePlace(scene, pick->modelInstance) : std::nullopt;
  auto middle = instance ? view.pixelFromWorld(instance->middle) : std::nullopt;
  if (!middle || glm::distance(*middle, pixel) > kSnapPixels) return {place, -1};
  return {instance->middle, int(pick->modelInstance)};
}

Mark withWordsBy(Mark mark, const PlacedWords& from, glm::dvec2 pixels, const ViewSpace& view) {
  mark.wordsAt = (0.5 * (from.low + from.high) + pixels - from.at) / view.size().y;
  return mark;
}

Mark markOfName(const PlacedWords& name) {
  return {.kind = MarkKind::Name, .structure = name.structure, .type = name.type};
}

Mark markOfClicks(MarkKind kind, std::vector<glm::dvec3> points, const ViewSpace& view, double step) {
  Mark mark{.kind = kind, .points = std::move(points)};
  const scene::SectionPlane* plane = view.section();
  if (plane && kind == MarkKind::Circle) mark.normal = plane->normal;
  if (!plane || kind != MarkKind::Box || mark.points.size() != 2) return mark;
  glm::dvec3 toB = mark.points[1] - mark.points[0];
  bool isFlat = std::abs(glm::dot(toB, plane->normal)) < step;
  if (isFlat) {
    mark.points[0] -= 0.5 * step * plane->normal;
    mark.points[1] += 0.5 * step * plane->normal;
  }
  return mark;
}

const Mark* findMark(const scene::Scene& scene, int id) {
  auto found = std::ranges::find(scene.lettering.marks, id, &Mark::id);
  return found == scene.lettering.marks.end() ? nullptr : &*found;
}

Mark* findMark(scene::Scene& scene, int id) {
  return const_cast<Mark*>(findMark(std::as_const(scene), id));  // NOLINT: the scene is not const
}

}  // namespace velum::session
