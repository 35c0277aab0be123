#include "session/lettering/NameRing.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <numeric>

#include "session/lettering/Leaders.h"

namespace velum::session {

namespace {

constexpr int kSlots = 240;        // around the ellipse
constexpr int kRingReach = 60;     // slots from the direction of an anchor to where its name may stand
constexpr double kTurn = 3.0;      // how soon a block that goes around turns its corner to the subject
constexpr double kStaysFor = 0.3;  // of a way in a film: so much shorter must a leader be for it
constexpr double kSmallest = 0.35, kRingShrink = 0.85;  // of the ellipse around the subject
constexpr double kNoPlace = std::numeric_limits<double>::infinity();

struct Ellipse {
  glm::dvec2 middle{0}, axes{1};
};

/// The smallest ellipse around the middle of a silhouette with the proportions of its box.
Ellipse ellipseAround(const Silhouette& silhouette, glm::dvec2 picture) {
  glm::dvec2 low(kNoPlace), high(-kNoPlace);
  auto forCorners = [&](auto visit) {
    for (std::size_t i = 0; i < silhouette.rows.size(); ++i)
      if (glm::dvec2 row = silhouette.rows[i]; row.x < row.y)
        for (double y : {double(i), double(i + 1)})
          for (double x : {row.x, row.y}) visit(glm::dvec2(x, y * silhouette.step));
  };
  forCorners([&](glm::dvec2 corner) {
    low = glm::min(low, corner);
    high = glm::max(high, corner);
  });
  if (low.x > high.x) return {picture * 0.5, picture * 0.25};
  Ellipse out{(low + high) * 0.5, glm::max((high - low) * 0.5, glm::dvec2(1))};
  double scale = 0.0;
  forCorners([&](glm::dvec2 corner) { scale = std::max(scale, glm::length((corner - out.middle) / out.axes)); });
  out.axes *= scale;
  return out;
}

class RingSearch {
 public:
  RingSearch(const WaitingNames& waiting, const NameRoom& room) : mWaiting(waiting), mRoom(room) {}

  std::vector<std::optional<glm::dvec2>> search() {
    std::vector<std::size_t> all(mWaiting.names.size());
    std::iota(all.begin(), all.end(), std::size_t(0));
    Ellipse around = ellipseAround(mRoom.subject, mRoom.size);
    std::vector<std::optional<glm::dvec2>> places(all.size());
    for (; !all.empty(); dropLightest(all))
      for (double share = 1.0; share >= kSmallest; share *= kRingShrink) {
        mRing = {around.middle, around.axes * share + kSubjectGap * mRoom.em};
        if (!arrange(all)) continue;
        for (std::size_t k = 0; k < mOrder.size(); ++k) places[mOrder[k]] = blockOf(k).low;
        return places;
      }
    return places;
  }

 private:
  const NameToPlace& name(std::size_t i) const { return mWaiting.names[i]; }

  void dropLightest(std::vector<std::size_t>& all) const {
    all.erase(std::min_element(all.begin(), all.end(), [&](std::size_t a, std::size_t b) {
      return name(a).weight != name(b).weight ? name(a).weight < name(b).weight : a > b;
    }));
  }

  /// In slots from the right, clockwise, 0..kSlots.
  double directionOf(glm::dvec2 place) const {
    glm::dvec2 away = (place - mRing.middle) / mRing.axes;
    double turn = std::atan2(away.y, away.x) / glm::two_pi<double>();
    return (turn < 0.0 ? turn + 1.0 : turn) * kSlots;
  }

  /// A block that touches the ellipse from outside: with a corner, above and below it with the middle of a side.
  Rectangle blockAt(std::size_t i, int slot) const {
    double angle = slot * glm::two_pi<double>() / kSlots;
    glm::dvec2 toRing(std::cos(angle), std::sin(angle)), half = name(i).size * 0.5;
    glm::dvec2 normal = glm::normalize(toRing / mRing.axes);
    glm::dvec2 offset = half * glm::clamp(normal * kTurn, -1.0, 1.0);
    double lacks = glm::dot(half, glm::abs(normal)) - glm::dot(offset, normal);
    glm::dvec2 middle = mRing.middle + toRing * mRing.axes + offset + normal * lacks;
    return {middle - half, middle + half};
  }

  /// What it costs to have a name there, pixels; infinite: it cannot be there.
  double costAt(std::size_t i, const Rectangle& block) const {
    double margin = kNameMargin * mRoom.em;
    if (glm::any(glm::lessThan(block.low, glm::dvec2(margin))) ||
        glm::any(glm::greaterThan(block.high, mRoom.size - margin)))
      return kNoPlace;
    Rectangle near = grown(block, kNameGap * mRoom.em);
    for (const Rectangle& taken : mRoom.taken)
      if (isCrossing(near, taken)) return kNoPlace;
    const NamePlace* before = mWaiting.before[i];
    double moved = before ? kStaysFor * glm::distance(before->block.low, block.low) : 0.0;
    Segment leader = leaderOf(block, name(i).anchor, kLeaderGap * mRoom.em, mRoom.order);
    return glm::distance(leader.from, leader.to) + moved;
  }

  /// Orders names by their directions, from the widest gap between them on.
  void order(const std::vector<std::size_t>& all) {
    std::vector<double> directions(mWaiting.names.size());
    mOrder = all;
    for (std::size_t i : all) {
      const NamePlace* before = mWaiting.before[i];
      directions[i] = directionOf(before ? (before->block.low + before->block.high) * 0.5 : name(i).anchor);
    }
    std::stable_sort(mOrder.begin(), mOrder.end(), [&](auto a, auto b) { return directions[a] < directions[b]; });
    std::size_t first = 0;
    double widest = 0.0;
    for (std::size_t k = 0; k < mOrder.size(); ++k) {
      double gap = directions[mOrder[k]] - directions[mOrder[k == 0 ? mOrder.size() - 1 : k - 1]];
      if (gap <= 0.0) gap += kSlots;
      if (gap <= widest) continue;
      widest = gap;
      first = k;
      mStart = int(std::floor(directions[mOrder[k]] - gap / 2));
    }
    std::rotate(mOrder.begin(), mOrder.begin() + std::ptrdiff_t(first), mOrder.end());
  }

  /// Finds slots for names, and changes their order while two are in each other's way. @return false: they do not fit
  bool arrange(const std::vector<std::size_t>& all) {
    order(all);
    fillSlots();
    for (std::size_t i = 0; i <= 2 * all.size(); ++i) {
      if (!findSlots()) return false;
      auto crossing = crossingOf();
      if (!crossing) break;
      std::swap(mOrder[crossing->first], mOrder[crossing->second]);
    }
    return true;
  }

  void fillSlots() {
    mBlocks.assign(mWaiting.names.size(), {});
    mCosts.assign(mWaiting.names.size(), std::vector<double>(kSlots, kNoPlace));
    for (std::size_t i : mOrder) {
      double direction = directionOf(name(i).anchor);
      for (int s = 0; s < kSlots; ++s) {
        mBlocks[i].push_back(blockAt(i, mStart + s));
        double away = std::abs(std::remainder(mStart + s - direction, double(kSlots)));
        if (away <= kRingReach) mCosts[i][std::size_t(s)] = costAt(i, mBlocks[i].back());
      }
    }
  }

  /// The cheapest slots for names in their order, each clear of the one before: by dynamic programming.
  bool findSlots() {
    std::size_t count = mOrder.size();
    std::vector<std::vector<std::size_t>> from(count, std::vector<std::size_t>(kSlots));
    std::vector<double> sums = mCosts[mOrder[0]], next(kSlots);
    std::vector<std::size_t> best(kSlots);
    for (std::size_t k = 1; k < count; ++k) {
      // The best of all slots of the name before up to each, of which those count that are clear of this one's.
      for (std::size_t s = 1; s < kSlots; ++s) best[s] = sums[best[s - 1]] <= sums[s] ? best[s - 1] : s;
      std::fill(next.begin(), next.end(), kNoPlace);
      const auto &own = mBlocks[mOrder[k]], &others = mBlocks[mOrder[k - 1]];
      for (std::size_t s = 1, clear = 0; s < kSlots; ++s) {
        double cost = mCosts[mOrder[k]][s];
        if (cost == kNoPlace) continue;
        Rectangle block = grown(own[s], kNameGap * mRoom.em);
        while (clear < s && !isCrossing(block, others[clear])) ++clear;
        while (clear > 0 && isCrossing(block, others[clear - 1])) --clear;
        if (clear == 0) continue;
        from[k][s] = best[clear - 1];
        next[s] = cost + sums[best[clear - 1]];
      }
      std::swap(sums, next);
    }
    auto least = std::min_element(sums.begin(), sums.end());
    if (*least == kNoPlace) return false;
    mSlots.assign(count, 0);
    std::size_t slot = std::size_t(least - sums.begin());
    for (std::size_t k = count; k-- > 0;) {
      mSlots[k] = slot;
      slot = from[k][slot];
    }
    return true;
  }

  const Rectangle& blockOf(std::size_t k) const { return mBlocks[mOrder[k]][mSlots[k]]; }

  std::optional<std::pair<std::size_t, std::size_t>> crossingOf() const {
    std::vector<NamePlace> places;
    for (std::size_t i = 0; i < mOrder.size(); ++i) {
      places.push_back(placeAt(name(mOrder[i]), blockOf(i).low, mRoom));
      for (std::size_t j = i; j-- > 0;)
        if (areInTheWay(places[i], places[j], mRoom.em)) return std::pair(j, i);
    }
    return std::nullopt;
  }

  const WaitingNames& mWaiting;
  const NameRoom& mRoom;
  Ellipse mRing;
  int mStart = 0;                               ///< slot from which all others are counted
  std::vector<std::size_t> mOrder;              ///< names, clockwise
  std::vector<std::size_t> mSlots;              ///< of names in that order
  std::vector<std::vector<Rectangle>> mBlocks;  ///< of each name in each slot
  std::vector<std::vector<double>> mCosts;
};

}  // namespace

std::vector<std::optional<glm::dvec2>> ringPlaces(const WaitingNames& waiting, const NameRoom& room) {
  return RingSearch(waiting, room).search();
}

}  // namespace velum::session
