#include "core/HalvedLabels.h"

#include <array>

#include "core/Parallel.h"

namespace velum {

namespace {

constexpr int kOfBrick = LabelVolume::kBrickSize;

/// Calls body(brick) for the bricks of fine labels that a brick of the halved ones is made of.
template <class Body>
void forFineBricks(const LabelVolume& fine, glm::ivec3 coarse, const Body& body) {
  for (int i = 0; i < 8; ++i) {
    glm::ivec3 at = 2 * coarse + glm::ivec3(i & 1, i >> 1 & 1, i >> 2);
    if (glm::all(glm::lessThan(at, fine.brickGrid()))) body(at);
  }
}

/// The id that stands for some.
std::uint16_t mostOf(const std::array<std::uint16_t, 8>& ids, int count) {
  std::uint16_t best = ids[0];
  int most = 0;
  for (int i = 0; i < count; ++i) {
    int alike = 0;
    for (int j = 0; j < count; ++j) alike += ids[std::size_t(j)] == ids[std::size_t(i)];
    if (alike > most || (alike == most && best == 0)) most = alike, best = ids[std::size_t(i)];
  }
  return best;
}

/// The ids of a box of the halved labels; a single one where all of its voxels have it.
std::vector<std::uint16_t> halvedBox(const LabelVolume& fine, glm::ivec3 origin, glm::ivec3 size) {
  std::optional<std::uint16_t> only = fine.brick(2 * origin / kOfBrick)[0];
  forFineBricks(fine, origin / kOfBrick, [&](glm::ivec3 at) {
    const auto& brick = fine.brick(at);
    if (brick.size() > 1 || brick[0] != only) only.reset();
  });
  if (only) return {*only};
  glm::ivec3 held = glm::min(fine.dims() - 2 * origin, 2 * size);
  std::vector<std::uint16_t> ids(std::size_t(held.x) * std::size_t(held.y) * std::size_t(held.z)), out;
  fine.read(2 * origin, held, ids);
  out.reserve(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        std::array<std::uint16_t, 8> eight{};
        int count = 0;
        for (int i = 0; i < 8; ++i) {
          glm::ivec3 p = 2 * glm::ivec3(x, y, z) + glm::ivec3(i & 1, i >> 1 & 1, i >> 2);
          if (glm::any(glm::greaterThanEqual(p, held))) continue;
          eight[std::size_t(count++)] =
              ids[(std::size_t(p.z) * std::size_t(held.y) + std::size_t(p.y)) * std::size_t(held.x) + std::size_t(p.x)];
        }
        out.push_back(mostOf(eight, count));
      }
  return out;
}

LabelVolume emptyHalf(const LabelVolume& fine) {
  glm::dmat4 fineFromCoarse(1.0);
  for (int axis = 0; axis < 3; ++axis) fineFromCoarse[axis][axis] = 2.0, fineFromCoarse[3][axis] = 0.5;
  return LabelVolume((fine.dims() + 1) / 2, fine.worldFromVoxel() * fineFromCoarse, fine.lengthUnit());
}

}  // namespace

const Shared<LabelVolume>& HalvedLabels::update(const Shared<LabelVolume>& fine) {
  bool isFollowed = mFine && (*mFine)->dims() == fine->dims() && (*mFine)->worldFromVoxel() == fine->worldFromVoxel();
  if (isFollowed && mFine->id() == fine.id()) return *mHalved;
  LabelVolume halved = isFollowed ? **mHalved : emptyHalf(*fine);
  std::vector<glm::ivec3> changed;
  glm::ivec3 grid = halved.brickGrid(), at;
  for (at.z = 0; at.z < grid.z; ++at.z)
    for (at.y = 0; at.y < grid.y; ++at.y)
      for (at.x = 0; at.x < grid.x; ++at.x) {
        bool hasChanged = !isFollowed;
        forFineBricks(*fine, at,
                      [&](glm::ivec3 b) { hasChanged = hasChanged || (*mFine)->brickId(b) != fine->brickId(b); });
        if (hasChanged) changed.push_back(at);
      }
  std::vector<std::vector<std::uint16_t>> ids(changed.size());
  auto sizeOf = [&](glm::ivec3 brick) { return glm::min(halved.dims() - brick * kOfBrick, glm::ivec3(kOfBrick)); };
  parallelFor(std::size_t(0), changed.size(),
              [&](std::size_t i) { ids[i] = halvedBox(*fine, changed[i] * kOfBrick, sizeOf(changed[i])); });
  for (std::size_t i = 0; i < changed.size(); ++i) {
    const auto& before = halved.brick(changed[i]);
    if (ids[i].size() == 1 && before.size() == 1 && before[0] == ids[i][0]) continue;
    glm::ivec3 size = sizeOf(changed[i]);
    ids[i].resize(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z), ids[i][0]);
    halved.write(changed[i] * kOfBrick, size, ids[i]);
  }
  mFine = fine;
  mHalved = Shared<LabelVolume>(std::move(halved));
  return *mHalved;
}

}  // namespace velum
