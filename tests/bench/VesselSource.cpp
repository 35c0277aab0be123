#include "VesselSource.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "io/phantoms/Vessels.h"

namespace velum::bench {

using namespace io::phantom;

namespace {

constexpr float kExtentMm = 128.0f, kLeastRadiusMm = 0.3f, kPitchMm = 8.0f;
constexpr float kGround = 140.0f, kTissue = 300.0f;
constexpr int kBrickSize = 64, kCoarsest = 128;
constexpr int kIndexCells = 64;  ///< of the index, along each axis

class VesselSource : public VoxelSource {
 public:
  VesselSource(int size, Progress& progress) {
    mHead.dims = glm::ivec3(size);
    mHead.type = SampleType::UInt16;
    mHead.modality = Modality::Angiography;
    mHead.name = "vessels";
    double spacing = double(kExtentMm) / size;
    for (int factor = 1;; factor *= 2) {
      VoxelLevel level;
      level.dims = (mHead.dims + factor - 1) / factor;
      level.brickSize = glm::min(level.dims, glm::ivec3(kBrickSize));
      level.worldFromVoxel = glm::dmat4(spacing * factor);
      level.worldFromVoxel[3] = glm::dvec4(glm::dvec3(spacing * (0.5 * factor - 0.5 * size)), 1.0);
      mLevels.push_back(level);
      if (level.dims.x <= kCoarsest) break;
    }
    mHead.worldFromVoxel = mLevels.front().worldFromVoxel;
    mHead.range = {0.0, 2000.0};
    Tree arteries = growVessels(Vec(-7.0f, 4.0f, -63.5f), 4.4f, kLeastRadiusMm, kPitchMm, 11),
         veins = growVessels(Vec(8.0f, 8.0f, -63.5f), 5.4f, kLeastRadiusMm, kPitchMm, 23);
    pushApart(veins, arteries, 0.6f);
    progress.throwIfCancelled();
    mCells.resize(std::size_t(kIndexCells) * kIndexCells * kIndexCells);
    addTubes(segments(veins), 1150.0f);
    addTubes(segments(arteries), 1600.0f);
  }

  const Volume& head() const override { return mHead; }
  void read(const BrickAddress& address, const SampleTarget& target) const override;

 private:
  struct Piece {
    Segment tube;
    float value;
  };
  void addTubes(const std::vector<Segment>& tubes, float value);
  glm::ivec3 cellOf(Vec p) const {
    return glm::clamp(glm::ivec3(glm::floor((p / kExtentMm + 0.5f) * float(kIndexCells))), 0, kIndexCells - 1);
  }
  std::vector<std::uint32_t>& cell(glm::ivec3 at) {
    return mCells[std::size_t((at.z * kIndexCells + at.y) * kIndexCells + at.x)];
  }

  Volume mHead;
  std::vector<Piece> mPieces;
  std::vector<std::vector<std::uint32_t>> mCells;  ///< pieces of tubes that come into each cell of the index
};

/// In pieces of a cell's length at most, each listed wherever it comes.
void VesselSource::addTubes(const std::vector<Segment>& tubes, float value) {
  float most = kExtentMm / kIndexCells;
  for (const Segment& tube : tubes) {
    int parts = std::max(1, int(std::ceil(glm::length(tube.b - tube.a) / most)));
    for (int i = 0; i < parts; ++i) {
      float s = float(i) / float(parts), t = float(i + 1) / float(parts);
      Segment piece{glm::mix(tube.a, tube.b, s), glm::mix(tube.a, tube.b, t), std::lerp(tube.radiusA, tube.radiusB, s),
                    std::lerp(tube.radiusA, tube.radiusB, t)};
      float around = std::max(piece.radiusA, piece.radiusB);
      glm::ivec3 low = cellOf(glm::min(piece.a, piece.b) - around), high = cellOf(glm::max(piece.a, piece.b) + around);
      for (glm::ivec3 at = low; at.z <= high.z; ++at.z)
        for (at.y = low.y; at.y <= high.y; ++at.y)
          for (at.x = low.x; at.x <= high.x; ++at.x) cell(at).push_back(std::uint32_t(mPieces.size()));
      mPieces.push_back({piece, value});
    }
  }
}

void VesselSource::read(const BrickAddress& address, const SampleTarget& target) const {
  BrickBox box = boxOf(*this, address);
  const VoxelLevel& level = mLevels[std::size_t(address.level)];
  auto spacing = float(level.worldFromVoxel[0][0]);
  Vec origin(glm::dvec3(level.worldFromVoxel * glm::dvec4(glm::dvec3(box.origin), 1.0)));
  Vec middle = origin + 0.5f * spacing * Vec(box.size - 1);
  // Far from the organ's border all is one material.
  float depth = vesselOrgan(middle), wide = spacing * glm::length(Vec(box.size));
  auto size = std::size_t(box.size.x) * std::size_t(box.size.y) * std::size_t(box.size.z);
  std::vector<float> values(size, depth < 0.0f ? kTissue : kGround);
  auto at = [&](int x, int y, int z) -> float& {
    return values[(std::size_t(z) * std::size_t(box.size.y) + std::size_t(y)) * std::size_t(box.size.x) +
                  std::size_t(x)];
  };
  if (std::abs(depth) < 2.0f * wide)
    for (int z = 0; z < box.size.z; ++z)
      for (int y = 0; y < box.size.y; ++y)
        for (int x = 0; x < box.size.x; ++x)
          at(x, y, z) = vesselOrgan(origin + spacing * Vec(x, y, z)) < 0.0f ? kTissue : kGround;
  std::vector<std::uint32_t> near;
  glm::ivec3 first = cellOf(origin - spacing), last = cellOf(origin + spacing * Vec(box.size));
  for (glm::ivec3 c = first; c.z <= last.z; ++c.z)
    for (c.y = first.y; c.y <= last.y; ++c.y)
      for (c.x = first.x; c.x <= last.x; ++c.x) {
        const auto& list = const_cast<VesselSource*>(this)->cell(c);
        near.insert(near.end(), list.begin(), list.end());
      }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  for (std::uint32_t i : near) {
    const auto& [tube, value] = mPieces[i];
    // Tubes thinner than a voxel fill a part of it.
    float radius = std::max(tube.radiusA, tube.radiusB), seen = std::max(radius, 0.6f * spacing);
    float share = (radius / seen) * (radius / seen), around = seen + 0.5f * spacing;
    glm::ivec3 from((glm::min(tube.a, tube.b) - around - origin) / spacing);
    glm::ivec3 to(glm::ceil((glm::max(tube.a, tube.b) + around - origin) / spacing));
    from = glm::max(from, 0), to = glm::min(to, box.size - 1);
    for (int z = from.z; z <= to.z; ++z)
      for (int y = from.y; y <= to.y; ++y)
        for (int x = from.x; x <= to.x; ++x) {
          float d = distance(tube, origin + spacing * Vec(x, y, z)) + radius - seen;
          float& now = at(x, y, z);
          now = std::max(now, std::lerp(kTissue, value, share * glm::clamp(0.5f - d / spacing, 0.0f, 1.0f)));
        }
  }
  // Noise: less in what is the mean of many voxels.
  float loud = 40.0f / float(1 << address.level);
  const float* value = values.data();
  for (int z = 0; z < box.size.z; ++z)
    for (int y = 0; y < box.size.y; ++y) {
      std::uint64_t row =
          hash(std::uint64_t(address.level), (std::uint64_t(box.origin.z + z) << 32) ^ std::uint64_t(box.origin.y + y));
      for (int x = 0; x < box.size.x; ++x, ++value) {
        row = row * 6364136223846793005ull + 1442695040888963407ull;
        float noisy = *value + loud * (float(row >> 40) * (2.0f / 16777216.0f) - 1.0f);
        auto sample = std::uint16_t(glm::clamp(noisy + 0.5f, 0.0f, 65535.0f));
        std::memcpy(target.first + x * target.x + y * target.y + z * target.z, &sample, sizeof(sample));
      }
    }
}

}  // namespace

std::unique_ptr<VoxelSource> makeVesselSource(int size, Progress& progress) {
  return std::make_unique<VesselSource>(size, progress);
}

}  // namespace velum::bench
