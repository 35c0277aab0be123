#include "session/lettering/NameRing.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <numeric>

#include "session/lettering/Leaders.h"

namespace velum::session {

namespace {

constexpr int kSlots = 240;                         // around the ellipse
constexpr int kReach = 60;                          // slots from the direction of an anchor to where its name may stand
constexpr double kTurn = 3.0;                       // how soon a block that goes around turns its corner to the subject
constexpr double kStaysFor = 0.3;                   // of a way in a film: so much shorter must a leader be for it
constexpr double kSmallest = 0.35, kShrink = 0.85;  // of the ellipse around the subject
constexpr double kNowhere = std::numeric_limits<double>::infinity();

struct Ellipse {
  glm::dvec2 middle{0}, axes{1};
};

/// The smallest ellipse around the middle of a silhouette with the proportions of its box.
Ellipse ellipseAround(const Silhouette& silhouette, glm::dvec2 picture) {
  glm::dvec2 low(kNowhere), high(-kNowhere);
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
      for (double share = 1.0; share >= kSmallest; share *= kShrink) {
        mRing = {around.middle, around.axes * share + kSubjectGap * mRoom.em};
        if (!arrange(all)) continue;
        for (std::size_t k = 0; k < mOrder.size(); ++k) places[mOrder[k]] = blockAt(mOrder[k], mSlots[k]).low;
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
  double costAt(std::size_t i, int slot) const {
    Rectangle block = blockAt(i, slot);
    double margin = kNameMargin * mRoom.em;
    if (glm::any(glm::lessThan(block.low, glm::dvec2(margin))) ||
        glm::any(glm::greaterThan(block.high, mRoom.size - margin)))
      return kNowhere;
    Rectangle near = grown(block, kNameGap * mRoom.em);
    for (const Rectangle& taken : mRoom.taken)
      if (isCrossing(near, taken)) return kNowhere;
    Segment leader = leaderOf(block, name(i).anchor, kLeaderGap * mRoom.em);
    const NamePlace* before = mWaiting.before[i];
    double moved = before ? kStaysFor * glm::distance(before->block.low, block.low) : 0.0;
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

  /// Finds slots for names, and changes their order while leaders cross. @return false: they do not fit
  bool arrange(const std::vector<std::size_t>& all) {
    order(all);
    fillCosts();
    for (std::size_t i = 0; i <= 2 * all.size(); ++i) {
      if (!findSlots()) return false;
      auto crossing = crossingOf();
      if (!crossing) break;
      std::swap(mOrder[crossing->first], mOrder[crossing->second]);
    }
    return true;
  }

  void fillCosts() {
    mCosts.assign(mWaiting.names.size(), std::vector<double>(kSlots, kNowhere));
    for (std::size_t i : mOrder) {
      double direction = directionOf(name(i).anchor);
      for (int s = 0; s < kSlots; ++s) {
        double away = std::abs(std::remainder(mStart + s - direction, double(kSlots)));
        if (away <= kReach) mCosts[i][std::size_t(s)] = costAt(i, mStart + s);
      }
    }
  }

  /// The cheapest slots for names in their order, each clear of the one before: by dynamic programming.
  bool findSlots() {
    std::size_t count = mOrder.size();
    std::vector<std::vector<int>> from(count, std::vector<int>(kSlots, -1));
    std::vector<double> sums = mCosts[mOrder[0]];
    for (std::size_t k = 1; k < count; ++k) {
      // The best of all slots up to each.
      std::vector<int> best(kSlots);
      std::iota(best.begin(), best.end(), 0);
      for (std::size_t s = 1; s < kSlots; ++s)
        if (sums[std::size_t(best[s - 1])] <= sums[s]) best[s] = best[s - 1];
      std::vector<double> next(kSlots, kNowhere);
      for (int s = 1; s < kSlots; ++s) {
        double cost = mCosts[mOrder[k]][std::size_t(s)];
        if (cost == kNowhere) continue;
        Rectangle block = grown(blockAt(mOrder[k], mStart + s), kNameGap * mRoom.em);
        int before = s - 1;
        while (before >= 0 && isCrossing(block, blockAt(mOrder[k - 1], mStart + before))) --before;
        if (before < 0) continue;
        from[k][std::size_t(s)] = best[std::size_t(before)];
        next[std::size_t(s)] = cost + sums[std::size_t(best[std::size_t(before)])];
      }
      sums = std::move(next);
    }
    auto least = std::min_element(sums.begin(), sums.end());
    if (*least == kNowhere) return false;
    mSlots.assign(count, 0);
    int slot = int(least - sums.begin());
    for (std::size_t k = count; k-- > 0;) {
      mSlots[k] = mStart + slot;
      slot = from[k][std::size_t(slot)];
    }
    return true;
  }

  std::optional<std::pair<std::size_t, std::size_t>> crossingOf() const {
    std::vector<Segment> leaders;
    for (std::size_t i = 0; i < mOrder.size(); ++i) {
      leaders.push_back(leaderOf(blockAt(mOrder[i], mSlots[i]), name(mOrder[i]).anchor, kLeaderGap * mRoom.em));
      for (std::size_t j = i; j-- > 0;)
        if (isCrossing(leaders[i], leaders[j])) return std::pair(j, i);
    }
    return std::nullopt;
  }

  const WaitingNames& mWaiting;
  const NameRoom& mRoom;
  Ellipse mRing;
  int mStart = 0;                           ///< slot from which all others are counted
  std::vector<std::size_t> mOrder;          ///< names, clockwise
  std::vector<int> mSlots;                  ///< of names in that order
  std::vector<std::vector<double>> mCosts;  ///< of each name in each slot
};

}  // namespace

std::vector<std::optional<glm::dvec2>> ringPlaces(const WaitingNames& waiting, const NameRoom& room) {
  return RingSearch(waiting, room).search();
}

}  // namespace velum::session
