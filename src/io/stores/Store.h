#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/Volume.h"
#include "io/read/Refuse.h"

/// Where the bytes of a store come from: a folder, or a ZIP archive of one.
namespace velum::io {

/// The bytes of one key. Any thread.
class Blob {
 public:
  virtual ~Blob() = default;
  virtual std::uint64_t size() const = 0;
  /// Fills all of `to` from byte `at`. @throw InputError when the bytes end before
  virtual void read(std::uint64_t at, std::span<std::byte> to) const = 0;
};

/// Bytes by keys such as "0/c/1/2/3". Any thread.
class Store {
 public:
  virtual ~Store() = default;
  /// What messages call the key.
  virtual Path pathOf(const std::string& key) const = 0;
  /// The bytes of a key; null where the store has none. @throw InputError when they are there and cannot be read
  virtual std::unique_ptr<Blob> open(const std::string& key) const = 0;
  /// Names of the folders in that of a key, in natural order; none where the store cannot list them.
  virtual std::vector<std::string> folders(const std::string& key) const;
};

/// @param path  a folder, or a ZIP archive; of an archive that holds nothing but one folder, that folder is the store
/// @throw InputError
std::unique_ptr<Store> openStore(const Path& path);

/// All bytes of a blob. @param most  more of them are refused  @throw InputError
Bytes bytesOf(const Blob& blob, const Path& path, std::uint64_t most);

/// The text of a key; empty where the store has none. Metadata is never larger than some megabytes.
/// @throw InputError
std::string textOf(const Store& store, const std::string& key);

/// The key of `name` below `folder`. Names come from strangers: those that lead out of the store are refused.
/// @param folder  a key, or empty for the store itself  @throw InputError
std::string keyBelow(const Store& store, const std::string& folder, std::string_view name);

}  // namespace velum::io
