#include "session/lettering/PlaceNames.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "session/lettering/Leaders.h"
#include "session/lettering/NameColumns.h"
#include "session/lettering/NameRing.h"

namespace velum::session {

namespace {

constexpr double kNameStep = 0.25;                 // ems a frame, along x and along y
constexpr double kStill = 0.2;                     // ems that a place may be off before its block moves
constexpr double kShareOfWay = 0.3;                // of the rest a frame
constexpr double kShift = 0.5, kMostShift = 20.0;  // ems
constexpr double kFar = 10.0;                      // ems: a longer way is a leap
constexpr double kNewStrength = 0.125;             // a frame
constexpr double kHeavierPlaced = 1.3;             // names that stand give way less than new ones

using Wanted = std::vector<std::optional<glm::dvec2>>;

/// How far a block goes of a way in a frame: never less for a longer way, and never by more than that is longer, so
/// that blocks of a column that all go so keep their order and their gaps.
double easedWay(double way, double em) {
  double most = std::max(0.0, std::abs(way) - kStill * em) * kShareOfWay;
  return std::copysign(std::min(most, kNameStep * em), way);
}

glm::dvec2 eased(glm::dvec2 from, glm::dvec2 to, double em) {
  return from + glm::dvec2(easedWay(to.x - from.x, em), easedWay(to.y - from.y, em));
}

/// Takes places, one name after the other, where nothing is in the way.
class Settled {
 public:
  Settled(const NameRoom& room, std::size_t count) : mRoom(room), mPlaces(count) {}

  void take(std::size_t i, NamePlace place) {
    mTaken.push_back(place);
    mPlaces[i] = std::move(place);
  }
  bool isFree(const NamePlace& place) const {
    if (glm::any(glm::lessThan(place.block.low, glm::dvec2(0))) ||
        glm::any(glm::greaterThan(place.block.high, mRoom.size)))
      return false;
    Segment leader{place.leader.front(), place.leader.back()};
    if (!glm::all(glm::greaterThanEqual(leader.to, glm::dvec2(0))) ||
        !glm::all(glm::lessThanEqual(leader.to, mRoom.size)))
      return false;
    Rectangle own = grown(place.block, 1.0);
    if (glm::all(glm::lessThan(own.low, leader.to)) && glm::all(glm::lessThan(leader.to, own.high))) return false;
    auto isOver = [&](const Rectangle& taken) { return isCrossing(taken, place.block) || isCrossing(leader, taken); };
    if (std::any_of(mRoom.taken.begin(), mRoom.taken.end(), isOver)) return false;
    return std::none_of(mTaken.begin(), mTaken.end(),
                        [&](const NamePlace& other) { return areInTheWay(place, other, mRoom.em); });
  }
  /// Takes the first of some places that is free. @return false: none is
  bool takeFirst(std::size_t i, const NameToPlace& name, const std::vector<glm::dvec2>& lows) {
    for (glm::dvec2 low : lows) {
      NamePlace place = placeAt(name, low, mRoom);
      if (!isFree(place)) continue;
      take(i, std::move(place));
      return true;
    }
    return false;
  }
  std::optional<NamePlace>& at(std::size_t i) { return mPlaces[i]; }

  std::vector<NamePlace> places() const {
    std::vector<NamePlace> out;
    for (const auto& place : mPlaces)
      if (place) out.push_back(*place);
    return out;
  }

 private:
  const NameRoom& mRoom;
  std::vector<NamePlace> mTaken;
  std::vector<std::optional<NamePlace>> mPlaces;
};

/// True where the leader of a place seems to lead to the anchor of another name.
bool isMistaken(const NamePlace& place, const std::vector<NameToPlace>& names, double em) {
  Segment leader{place.leader.front(), place.leader.back()};
  return std::any_of(names.begin(), names.end(), [&](const NameToPlace& other) {
    return glm::distance(other.anchor, leader.to) > 2.0 * kAnchorGap * em &&
           distanceTo(leader, other.anchor) < kAnchorGap * em;
  });
}

/// Moves wanted places a little up or down where their leaders seem to lead to the anchor of another name, if nothing
/// is in the way there.
void clearAnchors(const std::vector<NameToPlace>& names, const NameRoom& room, Wanted& wanted) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!wanted[i] || !isMistaken(placeAt(names[i], *wanted[i], room), names, room.em)) continue;
    for (double way : {0.3, -0.3, 0.6, -0.6, 0.9, -0.9}) {
      NamePlace place = placeAt(names[i], *wanted[i] + glm::dvec2(0.0, way * room.em), room);
      bool isFree = !isMistaken(place, names, room.em);
      for (std::size_t j = 0; j < names.size() && isFree; ++j)
        isFree = j == i || !wanted[j] || !areInTheWay(place, placeAt(names[j], *wanted[j], room), room.em);
      if (!isFree) continue;
      wanted[i] = place.block.low;
      break;
    }
  }
}

/// Where a name may be that was somewhere in the frame before: on its way to the wanted place, where it was, or aside
/// of what comes its way.
std::vector<glm::dvec2> stepsOf(glm::dvec2 from, glm::dvec2 wanted, double em) {
  glm::dvec2 whole = eased(from, wanted, em);
  std::vector<glm::dvec2> lows{whole, (from + whole) * 0.5, from};
  for (double y : {-1.0, 0.0, 1.0})
    for (double x : {-1.0, 0.0, 1.0})
      if (x != 0.0 || y != 0.0) lows.push_back(from + glm::dvec2(x, y) * kNameStep * em);
  std::stable_sort(lows.begin() + 3, lows.end(),
                   [&](glm::dvec2 a, glm::dvec2 b) { return glm::distance(a, wanted) < glm::distance(b, wanted); });
  return lows;
}

/// Gives a name the place that it wants, or one above or below it where something is in the way; in a film one that is
/// a step away from where it was, if it can be, and the way is not so far that it would fly over the picture.
void settleName(std::size_t i, const NameToPlace& name, const std::optional<glm::dvec2>& wanted, const NamePlace* old,
                bool isFilm, double em, Settled& settled) {
  std::vector<glm::dvec2> steps, leaps;
  if (old) steps = stepsOf(old->block.low, wanted.value_or(old->block.low), em);
  if (wanted) leaps.push_back(*wanted);
  for (double way = kShift; wanted && way <= kMostShift; way += kShift)
    for (double sign : {-1.0, 1.0}) leaps.push_back(*wanted + glm::dvec2(0.0, sign * way * em));
  bool isFar = old && wanted && glm::distance(old->block.low, *wanted) > kFar * em;
  bool hasLept = isFar && settled.takeFirst(i, name, {*wanted});
  bool hasStepped = !hasLept && settled.takeFirst(i, name, steps);
  hasLept = hasLept || (!hasStepped && settled.takeFirst(i, name, leaps));
  if (hasStepped) settled.at(i)->strength = std::min(1.0, old->strength + kNewStrength);
  if (hasLept && isFilm) settled.at(i)->strength = kNewStrength;
}

/// Numbers of names, the heaviest first.
std::vector<std::size_t> heaviestFirst(const std::vector<NameToPlace>& names) {
  std::vector<std::size_t> order(names.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return names[a].weight > names[b].weight; });
  return order;
}

}  // namespace

double mostNameStep(double em) { return kNameStep * em; }

std::vector<NamePlace> placeNames(const std::vector<NameToPlace>& names, const NameRoom& room,
                                  const std::vector<NamePlace>* before) {
  Settled settled(room, names.size());
  WaitingNames waiting;
  std::vector<std::size_t> numbers;
  NameRoom rest = room;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].fixed) {
      settled.take(i, placeAt(names[i], *names[i].fixed, room));
      rest.taken.push_back(settled.at(i)->block);
      continue;
    }
    const NamePlace* old = nullptr;
    if (before)
      for (const NamePlace& place : *before)
        if (place.key == names[i].key) old = &place;
    numbers.push_back(i);
    waiting.names.push_back(names[i]);
    waiting.before.push_back(old);
    if (old) waiting.names.back().weight *= kHeavierPlaced;
  }
  Wanted wanted = room.order == scene::NameOrder::Columns ? columnPlaces(waiting, rest) : ringPlaces(waiting, rest);
  clearAnchors(waiting.names, room, wanted);
  for (std::size_t i : heaviestFirst(waiting.names))
    settleName(numbers[i], waiting.names[i], wanted[i], waiting.before[i], before != nullptr, room.em, settled);
  return settled.places();
}

}  // namespace velum::session
