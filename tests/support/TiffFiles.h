#pragma once
#include <tiffio.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/Volume.h"

namespace velum::io {

/// How a TIFF file is made.
struct TiffMaking {
  const char* mode = "w8";  ///< of libtiff: 8 BigTIFF, b big-endian
  int tile = 0;             ///< edge of a tile; 0: strips
  int rows = 16;            ///< of a strip
  std::uint16_t packing = COMPRESSION_LZW;
  std::uint16_t photometric = PHOTOMETRIC_MINISBLACK;
  int samples = 1;
  bool isPlanar = false;
  int levels = 1;          ///< each half as large as the one before, rounded up
  bool isChained = false;  ///< coarser levels follow their page in the chain
  std::string description;
};

/// The samples of a page, at a level: [y][x][sample]
using PageSamples = std::function<Bytes(int page, int level, glm::ivec2 size)>;

inline glm::ivec2 sizeAt(glm::ivec2 size, int level) { return (size + (1 << level) - 1) >> level; }

inline void setPage(TIFF* file, const TiffMaking& how, glm::ivec2 size, SampleType type) {
  bool isFloat = type == SampleType::Float32 || type == SampleType::Float64;
  bool isSigned = type == SampleType::Int8 || type == SampleType::Int16 || type == SampleType::Int32;
  TIFFSetField(file, TIFFTAG_IMAGEWIDTH, size.x);
  TIFFSetField(file, TIFFTAG_IMAGELENGTH, size.y);
  TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, int(sampleSize(type)) * 8);
  TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, how.samples);
  TIFFSetField(file, TIFFTAG_SAMPLEFORMAT,
               isFloat    ? SAMPLEFORMAT_IEEEFP
               : isSigned ? SAMPLEFORMAT_INT
                          : SAMPLEFORMAT_UINT);
  TIFFSetField(file, TIFFTAG_COMPRESSION, how.packing);
  TIFFSetField(file, TIFFTAG_PHOTOMETRIC, how.photometric);
  TIFFSetField(file, TIFFTAG_PLANARCONFIG, how.isPlanar ? PLANARCONFIG_SEPARATE : PLANARCONFIG_CONTIG);
  if (how.tile > 0) {
    TIFFSetField(file, TIFFTAG_TILEWIDTH, how.tile);
    TIFFSetField(file, TIFFTAG_TILELENGTH, how.tile);
  } else {
    TIFFSetField(file, TIFFTAG_ROWSPERSTRIP, how.rows);
  }
}

/// Writes the samples of one page in its tiles or strips. @return whether the library did
inline bool writeSamples(TIFF* file, const TiffMaking& how, glm::ivec2 size, SampleType type, const Bytes& samples) {
  std::size_t sample = sampleSize(type);
  std::size_t together = how.isPlanar ? 1 : std::size_t(how.samples);
  glm::ivec2 chunk = how.tile > 0 ? glm::ivec2(how.tile) : glm::ivec2(size.x, how.rows);
  std::uint32_t number = 0;
  for (int s = 0; s < how.samples; s += int(together))
    for (int y = 0; y < size.y; y += chunk.y)
      for (int x = 0; x < size.x; x += chunk.x) {
        int rows = how.tile > 0 ? chunk.y : std::min(chunk.y, size.y - y);
        Bytes packed(std::size_t(chunk.x) * std::size_t(rows) * together * sample);
        std::fill(packed.begin(), packed.end(), std::byte(0xee));  // what lies beyond the border is nobody's
        for (int j = 0; j < rows && y + j < size.y; ++j)
          for (int i = 0; i < chunk.x && x + i < size.x; ++i)
            std::copy_n(samples.data() + (std::size_t(((y + j) * size.x + x + i) * how.samples + s)) * sample,
                        together * sample, packed.data() + std::size_t(j * chunk.x + i) * together * sample);
        auto bytes = tmsize_t(packed.size());
        tmsize_t written = how.tile > 0 ? TIFFWriteEncodedTile(file, number, packed.data(), bytes)
                                        : TIFFWriteEncodedStrip(file, number, packed.data(), bytes);
        if (written != bytes) return false;
        ++number;
      }
  return true;
}

/// Pages of one size, of what a function gives. @return whether the library wrote them
inline bool writeTiff(const std::filesystem::path& path, glm::ivec2 size, int pages, SampleType type,
                      const TiffMaking& how, const PageSamples& samples) {
  TIFF* file = TIFFOpen(path.c_str(), how.mode);
  bool isWritten = file != nullptr;
  for (int page = 0; isWritten && page < pages; ++page)
    for (int level = 0; isWritten && level < how.levels; ++level) {
      glm::ivec2 at = sizeAt(size, level);
      setPage(file, how, at, type);
      if (page == 0 && level == 0 && !how.description.empty())
        TIFFSetField(file, TIFFTAG_IMAGEDESCRIPTION, how.description.c_str());
      if (level > 0) TIFFSetField(file, TIFFTAG_SUBFILETYPE, FILETYPE_REDUCEDIMAGE);
      if (level == 0 && how.levels > 1 && !how.isChained) {
        std::vector<std::uint64_t> none(std::size_t(how.levels - 1), 0);
        TIFFSetField(file, TIFFTAG_SUBIFD, how.levels - 1, none.data());
      }
      isWritten = writeSamples(file, how, at, type, samples(page, level, at)) && TIFFWriteDirectory(file);
    }
  if (file) TIFFClose(file);
  return isWritten;
}

/// Any bytes, other ones in each page.
inline PageSamples anySamples(SampleType type, int samples) {
  return [=](int page, int level, glm::ivec2 size) {
    Bytes bytes(std::size_t(size.x) * std::size_t(size.y) * std::size_t(samples) * sampleSize(type));
    for (std::size_t i = 0; i < bytes.size(); ++i)
      bytes[i] = std::byte(i * 7 + i / 100 + std::size_t(page) * 31 + std::size_t(level) * 13);
    if (type == SampleType::Float32 || type == SampleType::Float64)  // no signalling numbers, which processors change
      for (std::size_t i = sampleSize(type) - 1; i < bytes.size(); i += sampleSize(type)) bytes[i] = std::byte(0x3f);
    return bytes;
  };
}

}  // namespace velum::io
