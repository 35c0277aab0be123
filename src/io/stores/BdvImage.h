#pragma once
#include <memory>
#include <string>
#include <vector>

#include "io/stores/ArraySource.h"
#include "io/stores/BdvVoxels.h"
#include "io/stores/StoreImage.h"

/// Images of BigDataViewer, in HDF5 or N5, with the XML that says where they lie.
namespace velum::io {

/// View setups that differ in nothing but their channel are the channels of one image; its key is "setup3" by the first
/// of them.
class BdvImages {
 public:
  /// @param data      what the XML says, or voxels themselves
  /// @param hasPlaces  there is an XML @throw InputError
  BdvImages(SpimData data, std::shared_ptr<const BdvVoxels> voxels, bool hasPlaces);

  std::vector<StoreImage> list() const;
  /// Reads the metadata of all levels of an image; empty key: the first. @throw InputError
  ArrayPyramid read(const std::string& key) const;

 private:
  using Group = std::vector<SpimData::Setup>;
  bool belongs(const SpimData::Setup& setup, const Group& group) const;
  std::string nameOf(const Group& group) const;
  glm::dmat4 registration(int timePoint, const SpimData::Setup& setup) const;
  glm::dmat4 place(const SpimData::Setup& setup, std::vector<std::string>& warnings) const;
  std::shared_ptr<const ChunkArray> firstArray(const Group& group, int level, std::string& key) const;
  void describeChannels(const Group& group, ArrayPyramid& pyramid) const;

  SpimData mData;
  std::shared_ptr<const BdvVoxels> mVoxels;
  bool mHasPlaces;
  std::vector<Group> mGroups;
};

}  // namespace velum::io
