#pragma once
#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace velum::io {

/// The properties of one page (image file directory) of a TIFF, as the file gives them.
struct TiffPage {
  std::uint64_t width = 0, height = 0;
  std::uint64_t bits = 1;                   ///< Per sample.
  std::uint64_t samples = 1;                ///< Per pixel.
  std::uint64_t sampleFormat = 1;           ///< 1 unsigned, 2 signed, 3 float.
  std::uint64_t compression = 1;            ///< 1: none.
  std::uint64_t photometric = 1;            ///< 1: black is zero, 2: RGB.
  std::uint64_t planar = 1;                 ///< 2: the samples of a pixel lie in planes of their own.
  std::uint64_t fillOrder = 1;              ///< 2: the bits of a byte are turned round.
  std::uint64_t tileWidth = 0;              ///< 0: there are strips.
  std::uint64_t tileHeight = 0;             ///< Rows of a tile or strip; 0: one strip for all rows.
  bool isReduced = false;                   ///< A thumbnail or a coarser level of the page before.
  std::uint64_t at = 0;                     ///< Byte offset of its directory.
  std::vector<std::uint64_t> subPages;      ///< Those of the directories that belong to it: coarser levels.
  std::uint64_t firstStrip = 0;             ///< Byte offset of the first strip or tile.
  bool isOneStretch = true;                 ///< Each strip or tile begins where the one before ends.
  std::uint64_t dataBytes = 0;              ///< Stored bytes of all strips or tiles.
  bool isDataInside = true;                 ///< All strips lie inside the file.
  double xResolution = 0, yResolution = 0;  ///< Pixels per unit; 0 when not given.
  std::uint64_t resolutionUnit = 2;         ///< 1 none, 2 inch, 3 cm.
};

/// The pages of a TIFF as its directories describe them; no pixel is read.
struct TiffPages {
  bool isBigEndian = false;
  bool isTruncated = false;  ///< The chain of pages, or a page, leads out of the file.
  std::vector<TiffPage> pages;
  std::string description;  ///< ImageDescription of the first page, at most 64 MiB.
};

/// Walks the directories of a classic or big TIFF. OpenImageIO cannot tell the end of a file from a damaged one, has no
/// count of pages and cuts descriptions at 64 KiB; so this function reads the directories first, and no memory is
/// allocated by sizes that only a header claims.
/// @param file  positioned anywhere, seekable
/// @param name  for the message  @param mostPages  only so many are looked at
/// @throw InputError when the file is not a TIFF, or no page of it can be read
TiffPages scanTiff(std::istream& file, const std::string& name, std::size_t mostPages = 1'000'000);

/// The pages whose directories belong to another page, as far as they can be read.
std::vector<TiffPage> scanSubPages(std::istream& file, const std::string& name, const TiffPage& page);

}  // namespace velum::io
