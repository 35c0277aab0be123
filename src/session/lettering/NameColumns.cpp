#include "session/lettering/NameColumns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "session/lettering/Leaders.h"
#include "session/lettering/Spacing.h"

namespace velum::session {

namespace {

constexpr double kWidestGap = 1.0;    // ems between names of a column that has room
constexpr double kBalance = 0.5;      // ems of leaders that a square of the difference of both columns is worth
constexpr double kOverSubject = 2.0;  // so much worse than a longer leader is a column that stands over the subject
constexpr double kStay = 3.0;         // ems of leaders for which no name changes its side in a film

/// Names of one side, from the top.
struct Column {
  bool isLeft = true;
  double edge = 0.0;  ///< towards the subject, where all words end or begin
  std::vector<std::size_t> names;
  std::vector<double> middles;
  double cost = 0.0;
};

struct Columns {
  Column left, right;
};

class ColumnSearch {
 public:
  ColumnSearch(const WaitingNames& waiting, const NameRoom& room)
      : mWaiting(waiting), mRoom(room), mEm(room.em), mIsBound(waiting.names.size()) {
    for (std::size_t i = 0; i < mIsBound.size(); ++i) mIsBound[i] = waiting.before[i] != nullptr;
    findSubject();
  }

  std::vector<std::optional<glm::dvec2>> search() {
    std::vector<std::size_t> all(mWaiting.names.size());
    std::iota(all.begin(), all.end(), std::size_t(0));
    dropToFit(all);
    std::optional<Columns> columns = bestOf(all);
    for (; !columns && !all.empty(); columns = bestOf(all)) dropLightest(all);
    // Names that keep their side against their anchors' order may meet in the middle: they are free to change it then.
    for (int i = 0; i < 3 && columns && freeCrossing(*columns); ++i) columns = bestOf(all);
    std::vector<std::optional<glm::dvec2>> places(mWaiting.names.size());
    if (columns)
      for (const Column* column : {&columns->left, &columns->right})
        for (std::size_t i = 0; i < column->names.size(); ++i)
          places[column->names[i]] = blockOf(*column, column->names[i], column->middles[i]).low;
    return places;
  }

 private:
  const NameToPlace& name(std::size_t i) const { return mWaiting.names[i]; }

  void findSubject() {
    mSubject = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (glm::dvec2 row : mRoom.subject.rows)
      if (row.x < row.y) mSubject = {std::min(mSubject.x, row.x), std::max(mSubject.y, row.y)};
    if (mSubject.x > mSubject.y) mSubject = glm::dvec2(mRoom.size.x / 2);
  }

  void dropLightest(std::vector<std::size_t>& all) const {
    all.erase(std::min_element(all.begin(), all.end(), [&](std::size_t a, std::size_t b) {
      return name(a).weight != name(b).weight ? name(a).weight < name(b).weight : a > b;
    }));
  }

  /// Leaves out what no two columns can hold.
  void dropToFit(std::vector<std::size_t>& all) const {
    auto height = [&] {
      return std::accumulate(all.begin(), all.end(), 0.0,
                             [&](double sum, std::size_t i) { return sum + name(i).size.y + kNameGap * mEm; });
    };
    while (!all.empty() && height() > 2.0 * mRoom.size.y) dropLightest(all);
  }

  bool wasLeft(std::size_t i) const {
    const NamePlace& place = *mWaiting.before[i];
    return place.block.low.x + place.block.high.x < 2.0 * place.leader.front().x;
  }
  /// Where a name counts as being when sides are chosen.
  double sideOf(std::size_t i) const {
    return name(i).anchor.x + (mIsBound[i] ? (wasLeft(i) ? -kStay : kStay) * mEm : 0.0);
  }

  /// The best of all ways to part names from left to right, none: they do not fit.
  std::optional<Columns> bestOf(std::vector<std::size_t> all) const {
    std::stable_sort(all.begin(), all.end(), [&](auto a, auto b) { return sideOf(a) < sideOf(b); });
    std::optional<Columns> best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k <= all.size(); ++k) {
      double apart = double(all.size()) - 2.0 * double(k);
      double cost = kBalance * mEm * apart * apart + costOfChange(all, k);
      if (cost >= least) continue;
      auto middle = all.begin() + std::ptrdiff_t(k);
      auto left = columnOf({all.begin(), middle}, true);
      auto right = left && cost + left->cost < least ? columnOf({middle, all.end()}, false) : std::nullopt;
      if (!right || cost + left->cost + right->cost >= least) continue;
      least = cost + left->cost + right->cost;
      best = Columns{std::move(*left), std::move(*right)};
    }
    return best;
  }

  double costOfChange(const std::vector<std::size_t>& all, std::size_t k) const {
    double cost = 0.0;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (mIsBound[all[i]] && wasLeft(all[i]) != (i < k)) cost += kStay * mEm;
    return cost;
  }

  Rectangle blockOf(const Column& column, std::size_t i, double middle) const {
    glm::dvec2 size = name(i).size;
    glm::dvec2 low(column.isLeft ? column.edge - size.x : column.edge, middle - size.y / 2);
    return {low, low + size};
  }
  Segment leaderAt(const Column& column, std::size_t i, double middle) const {
    return leaderOf(blockOf(column, i, middle), name(i).anchor, kLeaderGap * mEm, scene::NameOrder::Columns);
  }

  /// A column of names, from the top, whose leaders do not cross; none: they do not fit.
  std::optional<Column> columnOf(std::vector<std::size_t> members, bool isLeft) const {
    Column column{isLeft, 0.0, std::move(members), {}, 0.0};
    double widest = 0.0, margin = kNameMargin * mEm, gap = kSubjectGap * mEm;
    for (std::size_t i : column.names) widest = std::max(widest, name(i).size.x);
    if (widest > mRoom.size.x - 2.0 * margin) return std::nullopt;
    double outside = isLeft ? mSubject.x - gap : mSubject.y + gap;
    column.edge = isLeft ? std::clamp(outside, margin + widest, mRoom.size.x - margin)
                         : std::clamp(outside, margin, mRoom.size.x - margin - widest);
    auto stretches = freeStretches(isLeft ? column.edge - widest : column.edge, widest);
    std::stable_sort(column.names.begin(), column.names.end(),
                     [&](auto a, auto b) { return heightOf(a) < heightOf(b); });
    if (!arrange(column, stretches)) return std::nullopt;
    for (std::size_t i = 0; i < column.names.size(); ++i) {
      Segment leader = leaderAt(column, column.names[i], column.middles[i]);
      column.cost += glm::distance(leader.from, leader.to) + kOverSubject * std::abs(column.edge - outside);
    }
    return column;
  }

  /// By what names of a column are ordered: as in the frame before.
  double heightOf(std::size_t i) const {
    if (!mIsBound[i]) return name(i).anchor.y;
    return (mWaiting.before[i]->block.low.y + mWaiting.before[i]->block.high.y) * 0.5;
  }

  /// What is free of the heights of a column.
  std::vector<glm::dvec2> freeStretches(double x, double width) const {
    double margin = kNameMargin * mEm, gap = kNameGap * mEm;
    Rectangle whole{{x, margin}, {x + width, mRoom.size.y - margin}};
    std::vector<glm::dvec2> out{{whole.low.y, whole.high.y}};
    for (const Rectangle& taken : mRoom.taken) {
      Rectangle by = grown(taken, gap);
      if (by.low.x >= whole.high.x || by.high.x <= whole.low.x) continue;
      std::vector<glm::dvec2> left;
      for (glm::dvec2 stretch : out) {
        if (by.low.y > stretch.x) left.push_back({stretch.x, std::min(stretch.y, by.low.y)});
        if (by.high.y < stretch.y) left.push_back({std::max(stretch.x, by.high.y), stretch.y});
      }
      out = left;
    }
    return out;
  }

  /// Puts the names at their heights, and changes their order while leaders cross.
  bool arrange(Column& column, const std::vector<glm::dvec2>& stretches) const {
    std::size_t swaps = 4 * column.names.size();
    for (std::size_t i = 0; i <= swaps + 2; ++i) {
      if (!space(column, stretches)) return false;
      auto crossing = crossingOf(column);
      if (!crossing) break;
      if (i < swaps)
        std::swap(column.names[crossing->first], column.names[crossing->second]);
      else
        orderByDirection(column);
    }
    return true;
  }

  bool space(Column& column, const std::vector<glm::dvec2>& stretches) const {
    std::vector<Spaced> things;
    double room = 0.0;
    for (glm::dvec2 stretch : stretches) room += stretch.y - stretch.x;
    for (std::size_t i : column.names) {
      things.push_back({name(i).anchor.y, name(i).size.y});
      room -= name(i).size.y;
    }
    double gap = std::clamp(room / double(2 * things.size() + 1), kNameGap * mEm, kWidestGap * mEm);
    auto middles = spaceOut(things, gap, stretches);
    if (!middles) middles = spaceOut(things, kNameGap * mEm, stretches);
    if (middles) column.middles = std::move(*middles);
    return middles.has_value();
  }

  std::optional<std::pair<std::size_t, std::size_t>> crossingOf(const Column& column) const {
    std::vector<Segment> leaders;
    for (std::size_t i = 0; i < column.names.size(); ++i) {
      leaders.push_back(leaderAt(column, column.names[i], column.middles[i]));
      for (std::size_t j = i; j-- > 0;)
        if (isCrossing(leaders[i], leaders[j])) return std::pair(j, i);
    }
    return std::nullopt;
  }

  /// From the top each place gets the name whose leader leaves all other anchors below it: for places that stay as
  /// they are no leaders cross.
  void orderByDirection(Column& column) const {
    std::vector<std::size_t> left = column.names;
    for (std::size_t k = 0; k < column.names.size(); ++k) {
      auto steepness = [&](std::size_t i) {
        double across = (name(i).anchor.x - column.edge) * (column.isLeft ? 1.0 : -1.0);
        return (name(i).anchor.y - column.middles[k]) / std::max(across, 1e-3);
      };
      auto next =
          std::min_element(left.begin(), left.end(), [&](auto a, auto b) { return steepness(a) < steepness(b); });
      column.names[k] = *next;
      left.erase(next);
    }
  }

  /// Lets names whose leaders cross those of the other column forget their side. @return false: there were none
  bool freeCrossing(const Columns& columns) {
    bool hasFreed = false;
    const Column &a = columns.left, &b = columns.right;
    for (std::size_t i = 0; i < a.names.size(); ++i)
      for (std::size_t j = 0; j < b.names.size(); ++j) {
        if (!mIsBound[a.names[i]] && !mIsBound[b.names[j]]) continue;
        if (!isCrossing(leaderAt(a, a.names[i], a.middles[i]), leaderAt(b, b.names[j], b.middles[j]))) continue;
        mIsBound[a.names[i]] = mIsBound[b.names[j]] = false;
        hasFreed = true;
      }
    return hasFreed;
  }

  const WaitingNames& mWaiting;
  const NameRoom& mRoom;
  double mEm;
  glm::dvec2 mSubject{0};      ///< its left and right end
  std::vector<bool> mIsBound;  ///< to its side and order in the frame before
};

}  // namespace

std::vector<std::optional<glm::dvec2>> columnPlaces(const WaitingNames& waiting, const NameRoom& room) {
  return ColumnSearch(waiting, room).search();
}

}  // namespace velum::session
