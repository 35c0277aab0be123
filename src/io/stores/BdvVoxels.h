#pragma once
#include <memory>
#include <string>
#include <vector>

#include "io/stores/ChunkArray.h"
#include "io/stores/Hdf5File.h"
#include "io/stores/SpimData.h"
#include "io/stores/Store.h"

namespace velum::io {

/// Where BigDataViewer keeps voxels: an array for each time point, view setup and level. Any thread.
class BdvVoxels {
 public:
  virtual ~BdvVoxels() = default;
  /// How many voxels of the finest level one of each level stands for, along x, y, z; the finest first, never empty.
  /// @throw InputError
  virtual std::vector<glm::dvec3> factors(int setup) const = 0;
  virtual std::string key(int timePoint, int setup, int level) const = 0;
  /// Null where there is none. @throw InputError
  virtual std::shared_ptr<const ChunkArray> open(int timePoint, int setup, int level) const = 0;
  /// The setups and time points that are there, for voxels without an XML. @throw InputError
  virtual SpimData describe() const = 0;
};

std::shared_ptr<const BdvVoxels> bdvInHdf5(std::shared_ptr<const Hdf5File> file);
std::shared_ptr<const BdvVoxels> bdvInN5(std::shared_ptr<const Store> store);

/// Whether a file, or a store, is laid out so.
bool isBdv(const Hdf5File& file);
bool isBdv(const Store& store);

}  // namespace velum::io
