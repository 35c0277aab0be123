#include "io/models/Assembly.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "core/Text.h"

namespace velum::io {

namespace {

std::optional<std::int64_t> wholeIn(std::string_view text) {
  std::int64_t value = 0;
  auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || text.empty()) return std::nullopt;
  return value;
}

Pose product(const Pose& later, const Pose& first) {
  return {later.rotation * first.rotation, later.rotation * first.position + later.position};
}

/// The columns of a 3 x 4 matrix.
struct MatrixColumns {
  const CifColumn* matrix[3][3];
  const CifColumn* vector[3];

  explicit MatrixColumns(const CifTable& table) {
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) matrix[r][c] = table.find(fmt::format("matrix[{}][{}]", r + 1, c + 1));
      vector[r] = table.find(fmt::format("vector[{}]", r + 1));
    }
  }
  std::optional<Pose> pose(std::size_t row) const {
    glm::dmat3 m(1.0);
    glm::dvec3 t(0.0);
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c)
        if (matrix[r][c]) m[c][r] = matrix[r][c]->number(row);
      if (vector[r]) t[r] = vector[r]->number(row);
    }
    return poseOf(m, t);
  }
};

}  // namespace

std::vector<std::string_view> itemsOf(std::string_view list) {
  std::vector<std::string_view> items;
  while (!list.empty()) {
    std::size_t comma = std::min(list.find(','), list.size());
    if (std::string_view item = trimmed(list.substr(0, comma)); !item.empty()) items.push_back(item);
    list.remove_prefix(std::min(comma + 1, list.size()));
  }
  return items;
}

Operators::Operators(const CifTable* table, const Path& path) : mPath(path) {
  if (!table) return;
  MatrixColumns columns(*table);
  for (std::size_t row = 0; row < table->rows; ++row) {
    std::string name = table->text("id", row);
    auto pose = columns.pose(row);
    if (!pose) refuse(path, fmt::format("its operator {} is no rotation", inQuotes(name)));
    auto index = std::uint32_t(mPoses.size());
    mPoses.push_back(*pose);
    if (auto number = wholeIn(name)) mByNumber.try_emplace(*number, index);
    mByName.try_emplace(std::move(name), index);
  }
}

void Operators::addRange(std::int64_t from, std::int64_t to, std::vector<std::uint32_t>& list) const {
  for (auto at = mByNumber.lower_bound(from); at != mByNumber.end() && at->first <= to; ++at)
    list.push_back(at->second);
}

std::vector<std::uint32_t> Operators::listOf(std::string_view group, std::string_view expression) const {
  std::vector<std::uint32_t> list;
  for (std::string_view item : itemsOf(group)) {
    std::size_t dash = item.find('-', 1);
    if (dash != std::string_view::npos) {
      auto from = wholeIn(trimmed(item.substr(0, dash))), to = wholeIn(trimmed(item.substr(dash + 1)));
      if (from && to) {
        addRange(*from, *to, list);
        if (list.size() > kMostInstances) refuse(mPath, fmt::format("names more than {} instances", kMostInstances));
        continue;
      }
    }
    auto at = mByName.find(item);
    if (at == mByName.end())
      refuse(mPath, fmt::format("the assembly {} names an operator that is not there", inQuotes(expression)));
    list.push_back(at->second);
  }
  return list;
}

void Operators::forEach(std::string_view expression, const std::function<void(const Pose&)>& body) const {
  std::vector<std::vector<std::uint32_t>> factors;
  std::string_view rest = trimmed(expression);
  if (rest.find('(') == std::string_view::npos) {
    factors.push_back(listOf(rest, expression));
    rest = {};
  }
  while (!rest.empty()) {
    std::size_t open = rest.find('('), close = rest.find(')');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open || factors.size() >= 4)
      refuse(mPath, fmt::format("the assembly {} makes no sense", inQuotes(expression)));
    factors.push_back(listOf(rest.substr(open + 1, close - open - 1), expression));
    rest = trimmed(rest.substr(close + 1));
  }
  double count = 1.0;
  for (const auto& factor : factors) count *= double(factor.size());
  if (count > double(kMostInstances)) refuse(mPath, fmt::format("names more than {} instances", kMostInstances));
  // Counts up with the last factor the fastest.
  for (std::size_t i = 0; i < std::size_t(count); ++i) {
    std::size_t left = i;
    std::optional<Pose> pose;
    for (std::size_t f = factors.size(); f-- > 0;) {
      const Pose& own = mPoses[factors[f][left % factors[f].size()]];
      left /= factors[f].size();
      pose = pose ? product(own, *pose) : own;
    }
    if (pose) body(*pose);
  }
}

}  // namespace velum::io
