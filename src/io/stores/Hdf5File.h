#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/Volume.h"
#include "io/read/FileBytes.h"
#include "io/stores/ChunkType.h"

/// What is asked of the HDF5 library, which one thread at a time is in. Nothing else names it.
namespace velum::io {

/// A filter that packed the chunks of a dataset, by its registered number.
struct Hdf5Filter {
  int id = 0;
  std::string name;  ///< as the file calls it
};

/// Where the bytes of a chunk lie as they were packed.
struct Hdf5Piece {
  std::shared_ptr<const FileBytes> file;
  std::uint64_t at = 0, size = 0;
  std::uint32_t skipped = 0;  ///< bit i: the i-th filter was left out
};

/// A dataset that is open. Lists have an entry an axis, the slowest first. Any thread.
class Hdf5Dataset {
 public:
  virtual ~Hdf5Dataset() = default;
  /// Where a chunk lies; nothing where the file has none. @throw InputError for a dataset without chunks, too
  virtual std::optional<Hdf5Piece> find(std::span<const std::uint64_t> chunkIndex) const = 0;
  /// Samples of a box, as they are stored but unpacked by the library. @throw InputError
  virtual Bytes read(std::span<const std::uint64_t> origin, std::span<const std::uint64_t> size) const = 0;

  std::vector<std::uint64_t> shape, chunk;  ///< samples; no chunk: they lie in one piece
  ChunkType type;
  std::vector<Hdf5Filter> filters;
};

/// A file that is open for reading. Paths are "group/object", from its root. Any thread.
class Hdf5File {
 public:
  virtual ~Hdf5File() = default;
  virtual const Path& path() const = 0;
  virtual bool has(const std::string& object) const = 0;
  /// Names of what is in a group, in natural order; none where there is no such group.
  virtual std::vector<std::string> names(const std::string& group) const = 0;
  /// An attribute as text: a string, or an array of them, which are joined; nothing where there is none, or it is
  /// anything else.
  virtual std::optional<std::string> text(const std::string& object, const std::string& attribute) const = 0;
  /// All numbers of a small dataset of one or two axes; none where there is none. @throw InputError
  virtual std::vector<double> numbers(const std::string& dataset) const = 0;
  /// A dataset; null where there is none. @throw InputError where it cannot be read, or its samples are no numbers
  virtual std::unique_ptr<Hdf5Dataset> open(const std::string& dataset) const = 0;
};

/// @throw InputError for a file that is no HDF5, is damaged or cut short
std::unique_ptr<Hdf5File> openHdf5(const Path& path);

}  // namespace velum::io
