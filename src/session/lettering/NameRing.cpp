#include "session/lettering/NameRing.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <numeric>

#include "session/lettering/Leaders.h"

namespace velum::session {

namespace {

constexpr std::size_t kSlots = 240;     // around the ellipse
constexpr double kRingReach = 60;       // slots from the direction of an anchor to where its name may stand
constexpr std::size_t kMostStarts = 8;  // that are tried for the order around
constexpr double kTurn = 3.0;           // how soon a block that goes around turns its corner to the subject
constexpr double kRadial = 0.1;         // of the radius, by the square of the turn: what it costs not to stand there
constexpr double kStaysFor = 0.5;       // of a way in a film: so much shorter must a leader be for it
constexpr double kSmallest = 0.35, kRingShrink = 0.8;  // of the ellipse around the subject
constexpr double kNoPlace = std::numeric_limits<double>::infinity();

/// A line around a subject: an ellipse, or one whose exponent is over 2, which comes nearer to a box.
struct NameEllipse {
  glm::dvec2 middle{0}, axes{1};
  double exponent = 2.0;
};

double lengthBy(double exponent, glm::dvec2 way) {
  if (exponent == 2.0) return glm::length(way);
  return std::pow(std::pow(std::abs(way.x), exponent) + std::pow(std::abs(way.y), exponent), 1.0 / exponent);
}

/// The smallest such line around the middle of a silhouette with the proportions of its box.
NameEllipse ellipseAround(const Silhouette& silhouette, glm::dvec2 picture) {
  struct Kind {
    double exponent, area;  ///< with axes of 1
  };
  constexpr Kind kKinds[] = {{2.0, 3.142}, {3.0, 3.533}, {4.0, 3.708}, {6.0, 3.855}};
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
  glm::dvec2 middle = (low + high) * 0.5, half = glm::max((high - low) * 0.5, glm::dvec2(1));
  NameEllipse out;
  double least = kNoPlace;
  for (Kind kind : kKinds) {
    double scale = 0.0;
    forCorners([&](glm::dvec2 corner) { scale = std::max(scale, lengthBy(kind.exponent, (corner - middle) / half)); });
    if (scale * scale * kind.area >= least) continue;
    least = scale * scale * kind.area;
    out = {middle, half * scale, kind.exponent};
  }
  return out;
}

class RingSearch {
 public:
  RingSearch(const WaitingNames& waiting, const NameRoom& room) : mWaiting(waiting), mRoom(room) {}

  std::vector<std::optional<glm::dvec2>> search() {
    std::vector<std::size_t> all(mWaiting.names.size());
    std::iota(all.begin(), all.end(), std::size_t(0));
    NameEllipse around = ellipseAround(mRoom.subject, mRoom.size);
    std::vector<std::optional<glm::dvec2>> places(all.size());
    for (; !all.empty(); dropLightest(all))
      for (double share = 1.0; share >= kSmallest; share *= kRingShrink) {
        mRing = {around.middle, around.axes * share + kSubjectGap * mRoom.em, around.exponent};
        if (!arrange(all)) continue;
        for (std::size_t k = 0; k < mOrder.size(); ++k) places[mOrder[k]] = blockOf(k).low;
        return places;
      }
    return places;
  }

 private:
  const NameToPlace& name(std::size_t i) const { return mWaiting.names[i]; }

  /// Leaves out an eighth.
  void dropLightest(std::vector<std::size_t>& all) const {
    std::stable_sort(all.begin(), all.end(), [&](auto a, auto b) { return name(a).weight > name(b).weight; });
    all.resize(all.size() - (all.size() + 7) / 8);
  }

  /// In slots from the right, clockwise, 0..kSlots.
  double directionOf(glm::dvec2 place) const {
    glm::dvec2 away = (place - mRing.middle) / mRing.axes;
    double turn = std::atan2(away.y, away.x) / glm::two_pi<double>();
    return (turn < 0.0 ? turn + 1.0 : turn) * kSlots;
  }

  /// A block that touches the ellipse from outside: with a corner, above and below it with the middle of a side.
  Rectangle blockAt(std::size_t i, std::size_t slot) const {
    double angle = double(slot) * glm::two_pi<double>() / kSlots;
    glm::dvec2 toRing(std::cos(angle), std::sin(angle)), half = name(i).size * 0.5;
    toRing /= lengthBy(mRing.exponent, toRing);
    glm::dvec2 slope = glm::sign(toRing) * glm::pow(glm::abs(toRing), glm::dvec2(mRing.exponent - 1.0));
    glm::dvec2 normal = glm::normalize(slope / mRing.axes);
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

  /// Finds slots for names, and changes their order while two are in each other's way. @return false: they do not fit
  bool arrange(const std::vector<std::size_t>& all) {
    fillSlots(all);
    if (!findOrder(all)) return false;
    for (std::size_t i = 0; i < 2 * all.size(); ++i) {
      auto crossing = crossingOf();
      if (!crossing) break;
      std::swap(mOrder[crossing->first], mOrder[crossing->second]);
      if (findSlots() == kNoPlace) return false;
    }
    return true;
  }

  void fillSlots(const std::vector<std::size_t>& all) {
    mBlocks.assign(mWaiting.names.size(), {});
    mCosts.assign(mWaiting.names.size(), std::vector<double>(kSlots, kNoPlace));
    double radius = (mRing.axes.x + mRing.axes.y) * 0.5;
    for (std::size_t i : all) {
      double direction = directionOf(name(i).anchor);
      for (std::size_t s = 0; s < kSlots; ++s) {
        mBlocks[i].push_back(blockAt(i, s));
        double away = std::abs(std::remainder(double(s) - direction, double(kSlots)));
        double turn = away * glm::two_pi<double>() / kSlots;
        if (away <= kRingReach)
          mCosts[i][std::size_t(s)] = costAt(i, mBlocks[i].back()) + kRadial * radius * turn * turn;
      }
    }
  }

  /// Orders names by their directions, from that on which makes them cheapest. @return false: they do not fit
  bool findOrder(const std::vector<std::size_t>& all) {
    std::vector<double> directions(mWaiting.names.size());
    std::vector<std::size_t> sorted = all;
    for (std::size_t i : all) {
      const NamePlace* before = mWaiting.before[i];
      directions[i] = directionOf(before ? (before->block.low + before->block.high) * 0.5 : name(i).anchor);
    }
    std::stable_sort(sorted.begin(), sorted.end(), [&](auto a, auto b) { return directions[a] < directions[b]; });
    // Between which names the order begins and ends: where few stand.
    std::vector<std::pair<double, std::size_t>> gaps;
    for (std::size_t k = 0; k < sorted.size(); ++k) {
      double gap = directions[sorted[k]] - directions[sorted[k == 0 ? sorted.size() - 1 : k - 1]];
      gaps.push_back({k == 0 ? gap + kSlots : gap, k});
    }
    std::stable_sort(gaps.begin(), gaps.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    gaps.resize(std::min(gaps.size(), kMostStarts));
    double least = kNoPlace;
    std::vector<std::size_t> best;
    std::size_t start = 0;
    for (auto [gap, k] : gaps) {
      mStart = std::size_t(directions[sorted[k]] - gap / 2 + kSlots) % kSlots;
      mOrder = sorted;
      std::rotate(mOrder.begin(), mOrder.begin() + std::ptrdiff_t(k), mOrder.end());
      double cost = findSlots();
      if (cost >= least) continue;
      least = cost;
      best = mOrder;
      start = mStart;
    }
    if (least == kNoPlace) return false;
    mOrder = best;
    mStart = start;
    return findSlots() < kNoPlace;
  }

  std::size_t slotAt(std::size_t s) const { return mStart + s < kSlots ? mStart + s : mStart + s - kSlots; }

  /// What it costs to have the k-th name in a slot. The first and the last do not reach over where the order begins.
  double costOf(std::size_t k, std::size_t slot) const {
    double cost = mCosts[mOrder[k]][slot];
    if (cost == kNoPlace || mOrder.size() == 1 || (k > 0 && k + 1 < mOrder.size())) return cost;
    double angle = double(mStart) * glm::two_pi<double>() / kSlots;
    glm::dvec2 out(std::cos(angle), std::sin(angle));
    Segment start{mRing.middle, mRing.middle + out * (mRing.axes + glm::length(mRoom.size))};
    return isCrossing(start, grown(mBlocks[mOrder[k]][slot], kNameGap * mRoom.em * 0.5)) ? kNoPlace : cost;
  }

  /// The cheapest slots for names in their order from the first slot on, each clear of the one before: by dynamic
  /// programming. @return what they cost; infinite: they do not fit
  double findSlots() {
    std::size_t count = mOrder.size();
    std::vector<std::vector<std::size_t>> from(count, std::vector<std::size_t>(kSlots));
    std::vector<double> sums(kSlots), next(kSlots);
    for (std::size_t s = 0; s < kSlots; ++s) sums[s] = costOf(0, slotAt(s));
    std::vector<std::size_t> best(kSlots);
    for (std::size_t k = 1; k < count; ++k) {
      // The best of all slots of the name before up to each, of which those count that are clear of this one's.
      for (std::size_t s = 1; s < kSlots; ++s) best[s] = sums[best[s - 1]] <= sums[s] ? best[s - 1] : s;
      std::fill(next.begin(), next.end(), kNoPlace);
      const auto &own = mBlocks[mOrder[k]], &others = mBlocks[mOrder[k - 1]];
      for (std::size_t s = 1, clear = 0; s < kSlots; ++s) {
        double cost = costOf(k, slotAt(s));
        if (cost == kNoPlace) continue;
        Rectangle block = grown(own[slotAt(s)], kNameGap * mRoom.em);
        while (clear < s && !isCrossing(block, others[slotAt(clear)])) ++clear;
        while (clear > 0 && isCrossing(block, others[slotAt(clear - 1)])) --clear;
        if (clear == 0) continue;
        from[k][s] = best[clear - 1];
        next[s] = cost + sums[best[clear - 1]];
      }
      if (std::all_of(next.begin(), next.end(), [](double sum) { return sum == kNoPlace; })) return kNoPlace;
      std::swap(sums, next);
    }
    auto least = std::min_element(sums.begin(), sums.end());
    if (*least == kNoPlace) return kNoPlace;
    mSlots.assign(count, 0);
    std::size_t slot = std::size_t(least - sums.begin());
    for (std::size_t k = count; k-- > 0;) {
      mSlots[k] = slotAt(slot);
      slot = from[k][slot];
    }
    return *least;
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
  NameEllipse mRing;
  std::size_t mStart = 0;                       ///< slot from which on names stand in their order
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
