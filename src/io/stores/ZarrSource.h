#pragma once
#include <memory>
#include <string>
#include <vector>

#include "core/VoxelSource.h"
#include "io/stores/OmeImage.h"
#include "io/stores/ZarrBricks.h"

namespace velum::io {

/// An image of a Zarr store, level by level.
class ZarrSource : public VoxelSource {
 public:
  /// Reads the metadata of all levels. @param notes  go to the head's warnings
  /// @throw InputError when a level is missing, cannot be read, or does not fit the others
  ZarrSource(std::shared_ptr<const Store> store, OmeImage image, std::vector<std::string> notes);

  const Volume& head() const override { return mHead; }
  void read(const BrickAddress& address, const SampleTarget& target) const override;

  const OmeImage& image() const { return mImage; }
  /// How a level is stored.
  const ZarrArray& stored(int level) const { return mArrays[std::size_t(level)]->array(); }
  /// The file says nothing of where its coarser levels lie; they are taken as means of blocks and lie border on border.
  bool isAlignedByBorders() const { return mIsAlignedByBorders; }

 private:
  void openLevel(const OmeLevel& level);
  void describeHead();
  void placeLevels();
  void fillScales();
  bool holdsMeansOfBlocks() const;
  void takeOwnAttributes();

  std::shared_ptr<const Store> mStore;
  OmeImage mImage;
  Volume mHead;
  std::vector<std::unique_ptr<ZarrBricks>> mArrays;
  bool mIsAlignedByBorders = false;
};

}  // namespace velum::io
