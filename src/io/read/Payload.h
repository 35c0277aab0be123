#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "velum/core/Task.h"
#include "velum/core/Volume.h"

/// What the readers of headers with samples behind them (NIfTI, NRRD, MetaImage, MRC) share: bytes out of plain or
/// deflated files, and voxels out of those bytes. Samples go straight into the volume, piece by piece, so that a load
/// can be cancelled, a cut or damaged stream is noticed, and nothing is held twice.
///
/// ITK could read these files, but not so: its NIfTI reader turns scaled samples into floats, NaN into 0, holds all
/// twice and knows no NIfTI-2; its NRRD reader puts time before space; sheared matrices are refused; none can be
/// cancelled. The headers had to be checked before ITK in any case, and behind a header there is only zlib.
namespace velum::io {

using Path = std::filesystem::path;

/// "file: reason" as an InputError.
[[noreturn]] void failInput(const Path& file, std::string_view reason);
/// Text of a file, made fit for a one-line message: short and without control characters.
std::string inQuotes(std::string_view text);
/// Size of a regular file. @throw InputError when it is missing or not a regular file
std::uint64_t sizeOfFile(const Path& file);
std::string lowerCase(std::string_view text);
/// ".nii.gz", ".seg.nrrd" and the like are not taken apart: the name from its last dot, with ".gz" joined; lower case.
std::string lowerExtension(const Path& file);

/// Reads a file from front to back, inflating it when it is deflated.
class ByteSource {
 public:
  /// @param offset    where to start, in bytes of the file
  /// @param deflated  a gzip or zlib stream starts there
  /// @throw InputError
  ByteSource(const Path& file, std::uint64_t offset, bool deflated);
  ~ByteSource();
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;

  /// Bytes read: fewer than asked for only at the end. @throw InputError for a damaged stream
  std::size_t read(std::span<std::byte> to);
  /// Drops bytes. @return false when the end came first
  bool skip(std::uint64_t count);
  /// Reads on to the end of a deflated stream, where its checksum stands. @throw InputError when it is cut or wrong
  void verifyEnd();

 private:
  struct State;
  std::unique_ptr<State> mState;
};

/// True when the file starts with the two bytes of gzip.
bool isGzip(const Path& file);
/// The first bytes of a file, inflated when it is gzip; fewer when it is shorter or damaged.
std::string readHead(const Path& file, std::size_t count);

/// Types that files have; the 64-bit integers become Int32 where they fit, else Float64.
enum class StoredType { UInt8, Int8, UInt16, Int16, UInt32, Int32, Float32, Float64, Int64, UInt64 };
std::size_t storedSize(StoredType type);

enum class Packing { Raw, Deflate, Text };

/// A stretch of samples in a file.
struct Payload {
  Path file;
  std::uint64_t offset = 0;  ///< Bytes of the file before them, or before the deflated stream.
  std::uint64_t skip = 0;    ///< Bytes to drop after inflating.
  Packing packing = Packing::Raw;
};

/// What a header promises about the samples.
struct Layout {
  glm::i64vec3 dims{1};       ///< Voxels along x (fastest), y, z; as the header says, not yet checked.
  std::int64_t channels = 1;  ///< Samples per voxel.
  std::int64_t frames = 1;
  StoredType type = StoredType::UInt8;
  bool bigEndian = false;
  bool planarChannels = false;  ///< Channels are the slowest axis of the file; they are interleaved here.
};

/// Bytes of the samples. @throw InputError, naming @p header, for numbers that no volume can have
std::uint64_t layoutBytes(const Layout& layout, const Path& header);
/// @throw InputError when the files cannot hold so many bytes: a deflated file holds at most 1032 times its size
void checkJustified(std::span<const Payload> parts, std::uint64_t bytes, const Path& header);
/// A volume with the samples of @p layout, read from equally long @p parts in turn. Geometry is left to the caller.
/// @throw InputError for sizes that the files cannot justify, and for missing or damaged data; Cancelled
Volume readSamples(const Layout& layout, std::span<const Payload> parts, const Path& header, Progress& progress);

/// Sets worldFromVoxel from columns (mm per voxel step) and the centre of the first voxel. Columns that are zero, not
/// finite or in one plane are replaced by axes of @p fallbackSpacing (1 mm where that is not positive), with a warning.
void placeInWorld(Volume& volume, const glm::dmat3& columns, const glm::dvec3& origin,
                  const glm::dvec3& fallbackSpacing);
/// Finite and far enough from singular to be inverted.
bool isInvertible(const glm::dmat3& columns);

/// A file that a header names, taken relative to the header. Headers come from strangers, so the file must lie in the
/// header's folder or below, and be a regular file. @throw InputError
Path siblingFile(const Path& header, std::string_view name);

}  // namespace velum::io
