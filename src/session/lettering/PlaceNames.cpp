#include "session/lettering/PlaceNames.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "session/lettering/Leaders.h"
#include "session/lettering/NameColumns.h"
#include "session/lettering/NameRing.h"

namespace velum::session {

namespace {

constexpr double kNameStep = 0.25;      // ems a frame, along x and along y
constexpr double kStill = 0.2;          // ems that a place may be off before its block moves
constexpr double kShareOfWay = 0.3;     // of the rest a frame
constexpr double kNewStrength = 0.125;  // a frame
constexpr double kHeavierPlaced = 1.3;  // names that stand give way less than new ones

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
    Rectangle own = grown(place.block, 1.0);
    if (glm::all(glm::lessThan(own.low, leader.to)) && glm::all(glm::lessThan(leader.to, own.high))) return false;
    auto isOver = [&](const Rectangle& taken) { return isCrossing(taken, place.block) || isCrossing(leader, taken); };
    if (std::any_of(mRoom.taken.begin(), mRoom.taken.end(), isOver)) return false;
    return std::none_of(mTaken.begin(), mTaken.end(),
                        [&](const NamePlace& other) { return areInTheWay(place, other, mRoom.em); });
  }
  /// Takes the first of some places that is free. @return which; none: no place was taken
  std::optional<std::size_t> takeFirst(std::size_t i, const NameToPlace& name, const std::vector<glm::dvec2>& lows) {
    for (std::size_t k = 0; k < lows.size(); ++k) {
      NamePlace place = placeAt(name, lows[k], mRoom);
      if (!isFree(place)) continue;
      take(i, std::move(place));
      return k;
    }
    return std::nullopt;
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

/// Gives a name the place that it wants, or, in a film, one on the way there from where it was.
void settleName(std::size_t i, const NameToPlace& name, const std::optional<glm::dvec2>& wanted, const NamePlace* old,
                bool isFilm, double em, Settled& settled) {
  std::vector<glm::dvec2> lows;
  if (old && wanted)
    lows = {eased(old->block.low, *wanted, em), (old->block.low + eased(old->block.low, *wanted, em)) * 0.5};
  if (old) lows.push_back(old->block.low);
  std::size_t stays = lows.size();
  if (wanted) lows.push_back(*wanted);
  auto taken = settled.takeFirst(i, name, lows);
  if (!taken || !isFilm) return;
  settled.at(i)->strength = *taken < stays ? std::min(1.0, old->strength + kNewStrength) : kNewStrength;
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
  for (std::size_t i : heaviestFirst(waiting.names))
    settleName(numbers[i], waiting.names[i], wanted[i], waiting.before[i], before != nullptr, room.em, settled);
  return settled.places();
}

}  // namespace velum::session
