#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "io/read/FileBytes.h"

namespace velum::io {

/// A tile or strip of a page of a TIFF file.
struct TiffChunk {
  std::uint64_t directory = 0;                    ///< Byte offset of the page's directory.
  std::uint32_t number = 0;                       ///< Among the tiles or strips of the page.
  std::uint32_t width = 0, height = 0;            ///< What the page must have.
  std::uint32_t chunkWidth = 0, chunkHeight = 0;  ///< The same of its tiles, or strips, which are as wide as the page.
  std::uint64_t mostExpansion = 1;                ///< What a stored byte can become at most.
};

/// Unpacks tiles and strips of a TIFF file, whatever they are packed by. One thread at a time; others have their own.
class TiffDecoder {
 public:
  virtual ~TiffDecoder() = default;
  /// @param to  takes all samples of the tile, or of the strip as far as it has rows, in machine byte order
  /// @throw InputError for a page of another shape, and for what is damaged or cut short
  virtual void read(const TiffChunk& chunk, std::span<std::byte> to) = 0;
};

/// A decoder by libtiff. @param file  is read at any place by it. @throw InputError
std::unique_ptr<TiffDecoder> openTiffDecoder(std::shared_ptr<const FileBytes> file);

}  // namespace velum::io
