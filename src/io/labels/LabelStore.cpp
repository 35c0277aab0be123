#include "io/labels/LabelStore.h"

#include <cstring>

namespace velum::io {

namespace {

/// Labels as a source of one level, of 8 bits where the ids fit; of 64, which are carried, where the file that they
/// come from has ids of its own.
class LabelSource : public VoxelSource {
 public:
  explicit LabelSource(const LabelVolume& labels) : mLabels(labels) {
    auto used = labels.idsInUse();
    mHead.dims = labels.dims();
    mHead.type = used.empty() || used.back() < 256 ? SampleType::UInt8 : SampleType::UInt16;
    for (const LabelInfo& info : labels.table)
      if (info.fileId != 0) mWideIds.resize(65536), mWideIds[info.id] = info.fileId;
    for (std::size_t id = 0; id < mWideIds.size(); ++id)
      if (mWideIds[id] == 0) mWideIds[id] = id;
    if (isWide()) mHead.type = SampleType::Float64;
    mHead.worldFromVoxel = labels.worldFromVoxel();
    mHead.lengthUnit = labels.lengthUnit();
    mHead.name = labels.name;
    constexpr int kEdge = 2 * LabelVolume::kBrickSize;
    mLevels = {{mHead.dims, glm::min(mHead.dims, glm::ivec3(kEdge)), 1, 1, mHead.worldFromVoxel}};
  }
  const Volume& head() const override { return mHead; }
  bool isWide() const { return !mWideIds.empty(); }
  void read(const BrickAddress& address, const SampleTarget& target) const override {
    BrickBox box = boxOf(*this, address);
    std::vector<std::uint16_t> ids(std::size_t(box.size.x) * std::size_t(box.size.y) * std::size_t(box.size.z));
    mLabels.read(box.origin, box.size, ids);
    const std::uint16_t* id = ids.data();
    for (int z = 0; z < box.size.z; ++z)
      for (int y = 0; y < box.size.y; ++y)
        for (int x = 0; x < box.size.x; ++x, ++id) {
          std::byte* to = target.first + x * target.x + y * target.y + z * target.z;
          if (isWide())
            std::memcpy(to, &mWideIds[*id], sizeof(std::uint64_t));
          else if (mHead.type == SampleType::UInt8)
            *to = std::byte(*id);
          else
            std::memcpy(to, id, sizeof(*id));
        }
  }

 private:
  const LabelVolume& mLabels;
  Volume mHead;
  std::vector<std::uint64_t> mWideIds;  ///< by id; empty: ids are those of the file
};

}  // namespace

std::vector<std::string> writeLabelStore(const LabelVolume& labels, const Path& path, OmeVersion version,
                                         Progress& progress) {
  StoreOptions options;
  options.version = version;
  options.isLabels = true;
  options.structures = labels.table;
  LabelSource source(labels);
  options.carriesIds = source.isWide();
  return writeStore(source, path, options, progress);
}

}  // namespace velum::io
