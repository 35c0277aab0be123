#pragma once
#include <memory>
#include <string>
#include <vector>

#include "io/stores/OmeImage.h"
#include "io/stores/StoreSource.h"
#include "io/stores/ZarrBricks.h"

namespace velum::io {

/// An image of a Zarr store, level by level.
class ZarrSource : public StoreSource {
 public:
  /// Reads the metadata of all levels. @param notes  go to the head's warnings
  /// @throw InputError when a level is missing, cannot be read, or does not fit the others
  ZarrSource(std::shared_ptr<const Store> store, OmeImage image, std::vector<std::string> notes);

  void read(const BrickAddress& address, const SampleTarget& target) const override;
  /// {0, 0} of bricks that the store lacks where such are 0.
  std::optional<glm::dvec2> range(const BrickAddress& address) const override;

  const OmeImage& image() const { return mImage; }
  /// How a level is stored.
  const ZarrArray& stored(int level) const { return mArrays[std::size_t(level)]->array(); }

 private:
  std::vector<std::uint64_t> indexOf(const BrickAddress& address) const;
  void openLevel(const OmeLevel& level);
  void describeHead();
  void placeLevels();
  void fillScales();
  bool holdsMeansOfBlocks() const;
  void takeOwnAttributes();
  void describeFacts();

  std::shared_ptr<const Store> mStore;
  OmeImage mImage;
  std::vector<std::unique_ptr<ZarrBricks>> mArrays;
};

}  // namespace velum::io
