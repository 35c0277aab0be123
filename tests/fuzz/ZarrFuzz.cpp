#include <map>
#include <string>

#include "FuzzReader.h"
#include "core/VoxelSource.h"
#include "io/stores/ZarrSource.h"

namespace velum::io {

/// A store in memory, made of records: length of the key, key, length of the bytes (16 bits, low first), bytes.
class FuzzStore : public Store {
 public:
  FuzzStore(const std::uint8_t* data, std::size_t size) {
    std::string_view left(reinterpret_cast<const char*>(data), size);
    auto take = [&](std::size_t count) {
      std::string_view piece = left.substr(0, count);
      left.remove_prefix(piece.size());
      return piece;
    };
    while (left.size() > 3) {
      std::string key(take(std::size_t(std::uint8_t(take(1)[0]))));
      std::string_view length = take(2);
      std::size_t count = length.size() < 2 ? 0 : std::uint8_t(length[0]) + 256u * std::uint8_t(length[1]);
      mBytes[key] = std::string(take(count));
    }
  }
  Path pathOf(const std::string& key) const override { return Path("store") / key; }
  std::unique_ptr<Blob> open(const std::string& key) const override {
    auto found = mBytes.find(key);
    return found == mBytes.end() ? nullptr : std::make_unique<Piece>(found->second);
  }

 private:
  class Piece : public Blob {
   public:
    explicit Piece(const std::string& bytes) : mBytes(bytes) {}
    std::uint64_t size() const override { return mBytes.size(); }
    void read(std::uint64_t at, std::span<std::byte> to) const override {
      if (at > mBytes.size() || to.size() > mBytes.size() - at) refuse("store", "is cut short");
      std::copy_n(reinterpret_cast<const std::byte*>(mBytes.data()) + at, to.size(), to.begin());
    }

   private:
    const std::string& mBytes;
  };
  std::map<std::string, std::string> mBytes;
};

/// Metadata, and the voxels of the finest level that is small.
inline void readAll(std::shared_ptr<const Store> store) {
  Progress progress;
  for (const StoreImage& image : listImages(*store)) {
    auto read = readOmeImage(*store, image.key);
    if (!read) continue;
    ZarrSource source(store, *read, {});
    auto level = levelWithin(source, 1 << 20);
    bool isSmall = level && brickBytes(source.stored(*level)) <= 1 << 22;
    if (!isSmall) continue;
    Volume volume = readLevel(source, *level, progress);
    expectSound(volume);
  }
}

}  // namespace velum::io

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace velum::io;
  try {
    readAll(std::make_shared<FuzzStore>(data, size));
  } catch (const velum::Error& error) {
    expectOneLine(error);
  }
  return 0;
}
