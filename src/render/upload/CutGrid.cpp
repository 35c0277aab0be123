#include "render/upload/CutGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace velum::render {

namespace {

using shared::kCutGrid;
constexpr std::size_t kCells = std::size_t(kCutGrid) * kCutGrid * kCutGrid;
/// Cells reach a little further than they do: rays and rounding come to their faces from both sides.
constexpr float kMargin = 1.02f;

using List = std::vector<std::uint32_t>;

class Builder {
 public:
  Builder(std::span<const shared::CutData> cuts, const glm::mat4& sceneFromTex, bool hasSpares)
      : mCuts(cuts), mSceneFromTex(sceneFromTex), mHasSpares(hasSpares), mLists(kCells) {
    glm::vec3 x(sceneFromTex[0]), y(sceneFromTex[1]), z(sceneFromTex[2]);
    // The longest of its diagonals: the box may be sheared.
    mReach = 0.5f * std::max({glm::length(x + y + z), glm::length(x + y - z), glm::length(x - y + z),
                              glm::length(-x + y + z)});
  }

  void divide(glm::ivec3 first, int edge, const List& from) {
    float share = float(edge) / float(kCutGrid);
    glm::vec3 middle = (glm::vec3(first) + 0.5f * float(edge)) / float(kCutGrid);
    List list = thoseThatMatter(from, glm::vec3(mSceneFromTex * glm::vec4(middle, 1.0f)), mReach * share * kMargin);
    if (edge == 1) {
      mLists[std::size_t(first.x + kCutGrid * (first.y + kCutGrid * first.z))] = std::move(list);
      return;
    }
    int half = edge / 2;
    for (int i = 0; i < 8; ++i) divide(first + half * glm::ivec3(i & 1, i >> 1 & 1, i >> 2), half, list);
  }

  std::vector<std::uint32_t> texels(const List& outside) const {
    std::vector<std::uint32_t> out;
    std::size_t begin = kCells + 2;
    auto count = [&](const List& list) {
      out.push_back(std::uint32_t(begin));
      begin += list.size();
    };
    std::for_each(mLists.begin(), mLists.end(), count);
    count(outside);
    count({});
    for (const List& list : mLists) out.insert(out.end(), list.begin(), list.end());
    out.insert(out.end(), outside.begin(), outside.end());
    return out;
  }

 private:
  /// Joined cuts go together: what one of them keeps is kept.
  List thoseThatMatter(const List& from, glm::vec3 middle, float radius) const {
    List out, whole;
    float deepest = -radius;
    for (std::size_t begin = 0, end; begin < from.size(); begin = end) {
      float distance = distanceOf(from[begin], middle);
      bool isSheet = !std::isfinite(distance);
      for (end = begin + 1; end < from.size() && shared::cutPart(mCuts[from[end]]) == shared::kFoldJoined; ++end) {
        float other = distanceOf(from[end], middle);
        isSheet = isSheet || !std::isfinite(other);
        distance = std::max(distance, other);
      }
      if (distance > radius) continue;
      auto first = from.begin() + std::ptrdiff_t(begin), last = from.begin() + std::ptrdiff_t(end);
      out.insert(out.end(), first, last);
      if (isSheet || !(distance < deepest)) continue;
      deepest = distance;
      whole.assign(first, last);
    }
    return whole.empty() || mHasSpares ? out : whole;
  }

  /// A sheet has no distance that this could trust: minus infinity.
  float distanceOf(std::uint32_t i, glm::vec3 middle) const {
    const shared::CutData& cut = mCuts[i];
    if (cut.kind.x == shared::kCutMembrane) return -std::numeric_limits<float>::infinity();
    return shared::shapeDistance(cut, middle);
  }

  std::span<const shared::CutData> mCuts;
  glm::mat4 mSceneFromTex;
  bool mHasSpares;
  float mReach = 0;  ///< Half of the box's longest diagonal.
  std::vector<List> mLists;
};

}  // namespace

CutGrid makeCutGrid(std::span<const shared::CutData> cuts, const glm::mat4& sceneFromTex, bool hasSpares) {
  List all(cuts.size());
  std::iota(all.begin(), all.end(), 0u);
  Builder builder(cuts, sceneFromTex, hasSpares);
  builder.divide({0, 0, 0}, kCutGrid, all);
  return {builder.texels(all)};
}

}  // namespace velum::render
