#include <algorithm>
#include <array>

#include "core/LabelCover.h"
#include "shared/structure.h"

// Which structure places among labels belong to, by the covers of voxels.

namespace velum {

namespace {

constexpr int kBrickEdge = LabelVolume::kBrickSize;

std::size_t brickIndex(glm::ivec3 grid, glm::ivec3 at) {
  return (std::size_t(at.z) * std::size_t(grid.y) + std::size_t(at.y)) * std::size_t(grid.x) + std::size_t(at.x);
}
std::size_t voxelIndex(glm::ivec3 at) {
  return (std::size_t(at.z) * kBrickEdge + std::size_t(at.y)) * kBrickEdge + std::size_t(at.x);
}

}  // namespace

StructureField::StructureField(LabelCover cover, const StructureField* before) : mCover(std::move(cover)) {
  const LabelVolume& labels = *mCover.labels();
  glm::ivec3 grid = labels.brickGrid();
  // Where there is no border there is nothing to be made, and one entry does for all.
  auto plain = std::make_shared<Entry>();
  std::call_once(plain->isMade, [&] { plain->cover = {255}; });
  std::call_once(plain->isLabelledMade, [&] { plain->labelled = {255}; });
  bool isFollowed = before && before->mEntries.grid() == grid && before->mCover.borders() == mCover.borders();
  mEntries = isFollowed ? before->mEntries : BrickTable<std::shared_ptr<Entry>>(grid, plain);
  std::vector<bool> changed;
  if (isFollowed) changed = changedCovers(*before->mCover.labels(), labels);
  glm::ivec3 at;
  std::size_t i = 0;
  for (at.z = 0; at.z < grid.z; ++at.z)
    for (at.y = 0; at.y < grid.y; ++at.y)
      for (at.x = 0; at.x < grid.x; ++at.x, ++i) {
        if (isFollowed && !changed[i]) continue;
        if (!isUniformAround(labels, at))
          mEntries.put(at, std::make_shared<Entry>());
        else if (mEntries[at] != plain)
          mEntries.put(at, plain);
      }
}

StructureField::Entry& StructureField::entryOf(glm::ivec3 index) const { return *mEntries[index]; }

const LabelCover::Brick& StructureField::brick(glm::ivec3 index) const {
  Entry& entry = entryOf(index);
  std::call_once(entry.isMade, [&] { entry.cover = mCover.brick(index); });
  return entry.cover;
}

float StructureField::coverAt(glm::ivec3 voxel) const {
  const LabelCover::Brick& cover = brick(voxel / kBrickEdge);
  return float(cover.size() == 1 ? cover[0] : cover[voxelIndex(voxel % kBrickEdge)]) * (1.0f / 255.0f);
}

/// What part of a voxel has a label.
float StructureField::labelledShareAt(glm::ivec3 voxel) const {
  glm::ivec3 index = voxel / kBrickEdge;
  Entry& entry = entryOf(index);
  std::call_once(entry.isLabelledMade,
                 [&] { entry.labelled = mCover.brickOfSet(index, [](std::uint16_t id) { return id != 0; }); });
  const LabelCover::Brick& cover = entry.labelled;
  float share = float(cover.size() == 1 ? cover[0] : cover[voxelIndex(voxel % kBrickEdge)]) * (0.5f / 255.0f);
  return mCover.labels()->at(voxel) != 0 ? 0.5f + share : 0.5f - share;
}

std::vector<bool> changedCovers(const LabelVolume& before, const LabelVolume& now) {
  glm::ivec3 grid = now.brickGrid(), at;
  bool isSame = before.dims() == now.dims();
  std::vector<bool> changed(std::size_t(grid.x) * std::size_t(grid.y) * std::size_t(grid.z), !isSame);
  if (!isSame) return changed;
  for (at.z = 0; at.z < grid.z; ++at.z)
    for (at.y = 0; at.y < grid.y; ++at.y)
      for (at.x = 0; at.x < grid.x; ++at.x) {
        if (before.brickId(at) == now.brickId(at)) continue;
        glm::ivec3 low = glm::max(at - 1, glm::ivec3(0)), high = glm::min(at + 1, grid - 1);
        for (int z = low.z; z <= high.z; ++z)
          for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) changed[brickIndex(grid, {x, y, z})] = true;
      }
  return changed;
}

StructurePlace StructureField::at(glm::dvec3 voxel) const {
  const LabelVolume& labels = *mCover.labels();
  glm::dvec3 last = glm::dvec3(labels.dims()) - 1.0;
  if (glm::any(glm::lessThan(voxel, glm::dvec3(-0.5))) || glm::any(glm::greaterThan(voxel, last + 0.5))) return {};
  voxel = glm::clamp(voxel, glm::dvec3(0.0), last);
  // A voxel that is wholly inside has none of another structure around it, nor have the eight around the place.
  glm::ivec3 nearest(glm::floor(voxel + 0.5));
  if (coverAt(nearest) == 1.0f) return {labels.at(nearest), 1.0f};
  glm::ivec3 base = glm::min(glm::ivec3(voxel), glm::max(labels.dims() - 2, glm::ivec3(0)));
  glm::vec3 f(voxel - glm::dvec3(base));
  // Of all, and of those that have a label.
  shared::Votes votes = shared::noVotes(), labelled = shared::noVotes();
  std::array<float, 8> weights{};
  bool hasNobody = false;
  auto voxelOf = [&](std::size_t corner) { return base + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2); };
  for (std::size_t corner = 0; corner < weights.size(); ++corner) {
    glm::vec3 w = glm::mix(1.0f - f, f, glm::vec3(voxelOf(corner) - base));
    weights[corner] = w.x * w.y * w.z;
    if (!(weights[corner] > 0.0f)) continue;
    std::uint16_t id = labels.at(voxelOf(corner));
    float weight = weights[corner] * coverAt(voxelOf(corner));
    votes = shared::addVote(votes, id, weight);
    if (id != 0) labelled = shared::addVote(labelled, id, weight);
    hasNobody = hasNobody || id == 0;
  }
  shared::Owner owner = shared::ownerOf(votes);
  if (hasNobody && labelled.b != shared::kNobody) {
    float share = 0.0f;
    for (std::size_t corner = 0; corner < weights.size(); ++corner)
      if (weights[corner] > 0.0f) share += weights[corner] * labelledShareAt(voxelOf(corner));
    owner.id = share >= 0.5f ? shared::ownerOf(labelled).id : 0;
  }
  return {std::uint16_t(owner.id), owner.coverage};
}

}  // namespace velum
