#pragma once
#include <memory>
#include <string>
#include <vector>

#include "io/stores/ChunkArray.h"
#include "io/stores/Codecs.h"
#include "io/stores/Hdf5File.h"

namespace velum::io {

/// A dataset of HDF5 with three axes, z, y, x. Its chunks are read and unpacked here, on all cores; what only the
/// library can unpack, or lies in one piece, is read by it, by one thread at a time.
class Hdf5Array : public ChunkArray {
 public:
  /// @param name  of the dataset, for messages @throw InputError
  Hdf5Array(std::unique_ptr<Hdf5Dataset> dataset, const Path& file, const std::string& name);
  std::optional<Chunk> read(const FiveSizes& index) const override;

 private:
  Bytes unpack(const Hdf5Piece& piece) const;
  Chunk readByLibrary(const FiveSizes& index) const;

  std::unique_ptr<Hdf5Dataset> mDataset;
  bool mIsOurs = true;  ///< all filters are known here
  std::vector<Codec> mCodecs;
};

/// True for the first bytes of a file of HDF5.
bool isHdf5(std::string_view head);

/// The array of a dataset; null where the file has none. @throw InputError
std::shared_ptr<Hdf5Array> openArray(const Hdf5File& file, const std::string& dataset);

}  // namespace velum::io
