#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "FuzzReader.h"
#include "core/VoxelSource.h"
#include "io/stores/Store.h"
#include "io/stores/StoreSource.h"

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
  std::vector<std::string> folders(const std::string& key) const override {
    std::set<std::string> names;
    std::string folder = key.empty() ? key : key + "/";
    for (const auto& [name, bytes] : mBytes)
      if (std::size_t slash = name.find('/', folder.size()); name.starts_with(folder) && slash != name.npos)
        names.insert(name.substr(folder.size(), slash - folder.size()));
    return {names.begin(), names.end()};
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

/// Reads the voxels of the finest level that is small, whose chunks are small, too.
inline void readSmall(const StoreSource& source) {
  Progress progress;
  auto level = levelWithin(source, 1 << 20);
  if (!level) return;
  double chunk = double(sampleSize(source.head().type));
  for (std::uint64_t size : source.facts().levels[std::size_t(*level)].chunk) chunk *= double(size);
  if (chunk > 1 << 22) return;
  Volume volume = readLevel(source, *level, progress);
  expectSound(volume);
}

}  // namespace velum::io
