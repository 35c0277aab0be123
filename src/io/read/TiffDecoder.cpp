#include "io/read/TiffDecoder.h"

#include <fmt/format.h>
#include <tiffio.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>

#include "io/Plugins.h"

namespace velum::io {

namespace {

constexpr tmsize_t kMostAtOnce = tmsize_t(1) << 31;  ///< bytes that the library may allocate at once

/// The library's own place in the file, and what it complained of.
class LibraryDecoder : public TiffDecoder {
 public:
  explicit LibraryDecoder(std::shared_ptr<const FileBytes> file) : mFile(std::move(file)) {
    TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
    TIFFOpenOptionsSetMaxSingleMemAlloc(options, kMostAtOnce);
    TIFFOpenOptionsSetErrorHandlerExtR(options, takeError, this);
    TIFFOpenOptionsSetWarningHandlerExtR(options, dropWarning, nullptr);
    // r: read, m: never map, O: look up places of tiles when they are asked for.
    mTiff = TIFFClientOpenExt(mFile->path().c_str(), "rmO", this, readSome, refuseWrite, seek, close, sizeOf, nullptr,
                              nullptr, options);
    TIFFOpenOptionsFree(options);
    if (!mTiff) fail("is not a TIFF file that can be read");
  }
  ~LibraryDecoder() override {
    if (mTiff) TIFFClose(mTiff);
  }
  LibraryDecoder(const LibraryDecoder&) = delete;
  LibraryDecoder& operator=(const LibraryDecoder&) = delete;

  void read(const TiffChunk& chunk, std::span<std::byte> to) override {
    goTo(chunk.directory);
    expectShape(chunk, to.size());
    auto size = tmsize_t(to.size());
    bool isTiled = TIFFIsTiled(mTiff) != 0;
    tmsize_t got = isTiled ? TIFFReadEncodedTile(mTiff, chunk.number, to.data(), size)
                           : TIFFReadEncodedStrip(mTiff, chunk.number, to.data(), size);
    if (got != size) fail(fmt::format("{} {} is damaged or cut short", isTiled ? "tile" : "strip", chunk.number));
  }

 private:
  void goTo(std::uint64_t directory) {
    if (mDirectory == directory) return;
    mDirectory = 0;
    if (!TIFFSetSubDirectory(mTiff, directory)) fail("a page is damaged");
    mDirectory = directory;
  }

  void expectShape(const TiffChunk& chunk, std::size_t bytes) {
    auto field = [&](std::uint32_t tag) {
      std::uint32_t value = 0;
      return TIFFGetField(mTiff, tag, &value) ? value : 0;
    };
    std::uint16_t packing = 0;
    TIFFGetFieldDefaulted(mTiff, TIFFTAG_COMPRESSION, &packing);
    if (!TIFFIsCODECConfigured(packing))
      fail(fmt::format("pages that are packed by scheme {} cannot be read", packing));
    bool isTiled = TIFFIsTiled(mTiff) != 0, isTileWanted = chunk.chunkWidth > 0;
    std::uint32_t width = field(TIFFTAG_IMAGEWIDTH), height = field(TIFFTAG_IMAGELENGTH);
    bool isAlike = width == chunk.width && height == chunk.height && isTiled == isTileWanted;
    if (isTiled)
      isAlike = isAlike && field(TIFFTAG_TILEWIDTH) == chunk.chunkWidth &&
                field(TIFFTAG_TILELENGTH) == chunk.chunkHeight && TIFFTileSize64(mTiff) == bytes;
    else
      isAlike = isAlike && std::min(field(TIFFTAG_ROWSPERSTRIP), height) == chunk.chunkHeight &&
                TIFFVStripSize64(mTiff, rowsOf(chunk, height)) == bytes;
    std::uint32_t count = isTiled ? TIFFNumberOfTiles(mTiff) : TIFFNumberOfStrips(mTiff);
    if (!isAlike || chunk.number >= count) fail("its pages are not of one size, or are not packed alike");
    if (double(TIFFGetStrileByteCount(mTiff, chunk.number)) * double(chunk.mostExpansion) < double(bytes))
      fail("a page promises more than the file can hold");
  }

  /// Rows of that strip: the last one may have fewer.
  static std::uint32_t rowsOf(const TiffChunk& chunk, std::uint32_t height) {
    std::uint32_t strips = (height + chunk.chunkHeight - 1) / chunk.chunkHeight;
    std::uint32_t first = chunk.number % strips * chunk.chunkHeight;
    return std::min(chunk.chunkHeight, height - first);
  }

  [[noreturn]] void fail(const std::string& what) {
    mDirectory = 0;
    std::string said;
    std::swap(said, mComplaint);
    refuse(mFile->path(), said.empty() ? what : fmt::format("{} ({})", what, inQuotes(said)));
  }

  static LibraryDecoder& self(thandle_t handle) { return *static_cast<LibraryDecoder*>(handle); }
  static tmsize_t readSome(thandle_t handle, void* to, tmsize_t size) {
    LibraryDecoder& of = self(handle);
    // No exception may pass through the library.
    try {
      std::size_t got = of.mFile->readSome(of.mAt, {static_cast<std::byte*>(to), std::size_t(size)});
      of.mAt += got;
      return tmsize_t(got);
    } catch (const InputError&) {
      return -1;
    }
  }
  static tmsize_t refuseWrite(thandle_t, void*, tmsize_t) { return -1; }
  static toff_t seek(thandle_t handle, toff_t offset, int whence) {
    LibraryDecoder& of = self(handle);
    of.mAt = whence == SEEK_SET ? offset : whence == SEEK_CUR ? of.mAt + offset : of.mFile->size() + offset;
    return of.mAt;
  }
  static int close(thandle_t) { return 0; }
  static toff_t sizeOf(thandle_t handle) { return self(handle).mFile->size(); }
  static int takeError(TIFF*, void* user, const char*, const char* format, va_list values) {
    auto& of = *static_cast<LibraryDecoder*>(user);
    char text[256] = "";
    std::vsnprintf(text, sizeof(text), format, values);
    if (of.mComplaint.empty()) of.mComplaint = text;
    return 1;
  }
  static int dropWarning(TIFF*, void*, const char*, const char*, va_list) { return 1; }

  std::shared_ptr<const FileBytes> mFile;
  std::uint64_t mAt = 0, mDirectory = 0;
  std::string mComplaint;
  TIFF* mTiff = nullptr;
};

}  // namespace

std::unique_ptr<TiffDecoder> plugin::openTiffDecoder(std::shared_ptr<const FileBytes> file) {
  return std::make_unique<LibraryDecoder>(std::move(file));
}

}  // namespace velum::io
