#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/Task.h"
#include "core/Volume.h"
#include "io/read/Refuse.h"

/// Shared by the readers of formats with a header and samples: makes voxels from the bytes of plain or deflated files.
/// Samples go straight into the volume, piece by piece, so that loading can be cancelled, a cut or damaged stream is
/// noticed, and no sample is held in memory twice.
///
/// ITK could read these files, but not in this way: its NIfTI reader turns scaled samples into floats and NaN into 0,
/// holds all samples twice and does not know NIfTI-2; its NRRD reader puts time before space; sheared matrices are
/// refused; no ITK reader can be cancelled. The headers had to be checked before ITK in any case, and behind a header
/// there is only zlib.
namespace velum::io {

/// Types of samples in files; in volumes the 64-bit integers become Int32 where all values fit, else Float64.
enum class StoredType { UInt8, Int8, UInt16, Int16, UInt32, Int32, Float32, Float64, Int64, UInt64 };
std::size_t storedSize(StoredType type);

/// Writes a number to the place of a sample, as the nearest value that the sample's type has; the 64-bit integer types
/// are written as doubles.
void storeNumber(double value, StoredType type, std::byte* to);

enum class Packing { Raw, Deflate, Text };

/// A stretch of samples in a file.
struct Payload {
  Path file;
  std::uint64_t offset = 0;  ///< Bytes of the file before the samples, or before the deflated stream.
  std::uint64_t skip = 0;    ///< Inflated bytes to drop before the samples.
  Packing packing = Packing::Raw;
};

/// Where the samples of a voxel lie in a file; in volumes they are together.
enum class ChannelOrder {
  Together,
  Planes,  ///< a plane of the first channel, the same of the next ones, the next plane
  Volumes  ///< channels are the slowest axis of the file
};

/// What a header promises about the samples.
struct Layout {
  glm::i64vec3 dims{1};       ///< Voxels along x (fastest), y, z; as the header says, not yet checked.
  std::int64_t channels = 1;  ///< Samples per voxel.
  std::int64_t timeSteps = 1;
  StoredType type = StoredType::UInt8;
  bool bigEndian = false;
  ChannelOrder channelOrder = ChannelOrder::Together;
};

/// A volume whose header was read, and whose samples were not.
struct UnreadVolume {
  Volume
      head;  ///< All but the voxels. Where these are stored in 64-bit integers, its type is known once they are read.
  Layout layout;
  std::vector<Payload> parts;  ///< Equally long, one behind the other.
  Path header;                 ///< The file that messages name.
};

/// How many bytes the samples take in the file. @throw InputError, naming @p header, for numbers that no volume can
/// have
std::uint64_t layoutBytes(const Layout& layout, const Path& header);
/// What a header promises, with the shape of @p layout in its head. Geometry is left to the caller.
/// @throw InputError for sizes that the files cannot justify
UnreadVolume promiseSamples(const Layout& layout, std::vector<Payload> parts, const Path& header);
/// The volume with its samples. @throw InputError for missing or damaged data; Cancelled
Volume readSamples(UnreadVolume unread, Progress& progress);

}  // namespace velum::io
