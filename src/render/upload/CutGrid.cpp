#include "CutGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
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
  List thoseThatMatter(const List& from, glm::vec3 middle, float radius) const {
    List out;
    float deepest = -radius;
    std::int64_t whole = -1;
    for (std::uint32_t i : from) {
      const shared::CutData& cut = mCuts[i];
      // A sheet has no distance that this could trust.
      if (cut.kind.x == shared::kCutMembrane) {
        out.push_back(i);
        continue;
      }
      float distance = shared::shapeDistance(cut, middle);
      if (distance > radius) continue;
      out.push_back(i);
      if (!(distance < deepest)) continue;
      deepest = distance;
      whole = i;
    }
    if (whole >= 0 && !mHasSpares) return {std::uint32_t(whole)};
    return out;
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
