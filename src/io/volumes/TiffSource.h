#pragma once
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/VoxelSource.h"
#include "io/read/TiffDecoder.h"
#include "io/volumes/TiffStack.h"

namespace velum::io {

/// The planes of a TIFF file, in tiles or strips, with the coarser levels that belong to its pages. Bricks are as wide
/// as a tile, or as the plane where there are strips, and of several planes where that is little.
class TiffSource : public VoxelSource {
 public:
  /// How the pages of a level are stored.
  struct Stored {
    std::vector<std::uint64_t> directories;  ///< of each plane [time][channel][z]
    std::vector<std::uint64_t> plain;        ///< byte offset of each plane; empty where planes are packed or in tiles
    glm::ivec2 chunk{0};                     ///< of a tile, or of a strip, which is as wide as the page
    bool isTiled = false;
    std::uint64_t mostExpansion = 1;  ///< what a stored byte can become
  };
  /// @param head  complete  @param samples  of a pixel  @param isPlanar  which lie in planes of their own
  TiffSource(std::shared_ptr<const FileBytes> file, Volume head, int samples, bool isPlanar, bool isBigEndian);

  /// Adds a level, the finest first. @param dims  of its planes  @param factor  voxels of the finest in one of its own
  void addLevel(Stored stored, glm::ivec2 dims, glm::dvec2 factor);

  const Volume& head() const override { return mHead; }
  void read(const BrickAddress& address, const SampleTarget& target) const override;
  std::string identity() const override;

 private:
  void readPlain(std::uint64_t plane, const BrickBox& box, const SampleTarget& target) const;
  void readChunks(int level, std::size_t plane, int sample, const BrickBox& box, const SampleTarget& target) const;
  std::unique_ptr<TiffDecoder> takeDecoder() const;
  void giveBack(std::unique_ptr<TiffDecoder> decoder) const;
  /// Bytes from a pixel to the next one.
  std::size_t pixelBytes() const;

  std::shared_ptr<const FileBytes> mFile;
  Volume mHead;
  int mSamples;
  bool mIsPlanar, mIsBigEndian;
  std::vector<Stored> mStored;
  mutable std::mutex mGuard;
  mutable std::vector<std::unique_ptr<TiffDecoder>> mDecoders;  ///< that no thread uses now
};

}  // namespace velum::io
