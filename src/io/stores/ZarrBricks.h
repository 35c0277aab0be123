#pragma once
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <span>

#include "io/stores/ZarrArray.h"

namespace velum::io {

/// Reads the bricks of a Zarr array. Any thread, several at a time.
class ZarrBricks {
 public:
  ZarrBricks(std::shared_ptr<const Store> store, ZarrArray array);
  const ZarrArray& array() const { return mArray; }
  /// The bytes of a brick, unpacked, as its samples are stored; nothing where the store lacks it, which means that all
  /// samples are the fill value. @param index  of the brick along each axis  @throw InputError
  std::optional<Bytes> read(std::span<const std::uint64_t> index) const;
  /// Whether the store has a brick. @throw InputError for a damaged shard
  bool has(std::span<const std::uint64_t> index) const;

 private:
  /// A shard that is open, and where its bricks lie in it: offset and size of each.
  struct Shard {
    std::string key;
    std::unique_ptr<Blob> blob;  ///< null: the store has none
    std::vector<std::uint64_t> index;
  };
  /// A brick in the shard that holds it, or would.
  struct Place {
    std::string key;
    std::shared_ptr<const Shard> shard;
    std::uint64_t at = 0, size = 0;
    bool isThere = false;
  };
  Place find(std::span<const std::uint64_t> index) const;
  std::shared_ptr<const Shard> openShard(const std::string& key) const;
  std::shared_ptr<const Shard> readShard(const std::string& key) const;
  std::optional<Bytes> readInShard(std::span<const std::uint64_t> index) const;
  Bytes unpack(Bytes packed, const std::string& key) const;

  std::shared_ptr<const Store> mStore;
  ZarrArray mArray;
  std::size_t mBricksOfShard = 1;
  mutable std::mutex mGuard;
  mutable std::list<std::shared_ptr<const Shard>> mShards;  ///< the last used ones, the newest first
};

}  // namespace velum::io
