#pragma once
#include <algorithm>
#include <charconv>
#include <map>
#include <set>

#include "FuzzFile.h"
#include "io/stores/Hdf5File.h"

namespace velum::io {

/// What the HDF5 library says of a file, from records as FuzzStore takes them. Keys: "a/b@Name" is an attribute;
/// "a/b" a dataset, its bytes a type, the number of filters, the low byte of each one's number with 125 taken for those
/// of strangers, then shape and chunk; "a/b#0.1.2" a chunk.
class FuzzHdf5 : public Hdf5File {
 public:
  FuzzHdf5(const std::uint8_t* data, std::size_t size) : mPath(file().path()) {
    file().hold(data, size);
    mFile = std::make_shared<const FileBytes>(mPath);
    std::string_view all(reinterpret_cast<const char*>(data), size);
    for (std::size_t at = 0; at + 3 < all.size();) {
      std::size_t length = std::uint8_t(all[at]);
      std::string key(all.substr(at + 1, length));
      at += 1 + key.size();
      if (at + 2 > all.size()) return;
      std::size_t count = std::uint8_t(all[at]) + 256u * std::uint8_t(all[at + 1]);
      mRecords[key] = {at + 2, std::min(count, all.size() - at - 2)};
      at += 2 + mRecords[key].second;
    }
  }
  const Path& path() const override { return mPath; }
  bool has(const std::string& object) const override {
    auto next = mRecords.lower_bound(object);
    for (; next != mRecords.end() && next->first.starts_with(object); ++next)
      if (std::string_view rest = std::string_view(next->first).substr(object.size());
          rest.empty() || rest[0] == '/' || rest[0] == '@')
        return true;
    return false;
  }
  std::vector<std::string> names(const std::string& group) const override {
    std::set<std::string> names;
    std::string folder = group.empty() ? group : group + "/";
    for (const auto& [key, where] : mRecords)
      if (key.starts_with(folder))
        names.insert(key.substr(folder.size(), key.find_first_of("/@#", folder.size()) - folder.size()));
    return {names.begin(), names.end()};
  }
  std::optional<std::string> text(const std::string& object, const std::string& attribute) const override {
    return bytesOfKey(object + "@" + attribute);
  }
  std::vector<double> numbers(const std::string& dataset) const override {
    std::string bytes = bytesOfKey(dataset).value_or("");
    return {bytes.begin(), bytes.end()};
  }
  std::unique_ptr<Hdf5Dataset> open(const std::string& name) const override {
    auto header = bytesOfKey(name);
    if (!header) return nullptr;
    auto made = std::make_unique<Dataset>(*this, name);
    std::string_view left = *header;
    auto take = [&] {
      int value = left.empty() ? 1 : std::uint8_t(left[0]);
      left.remove_prefix(left.empty() ? 0 : 1);
      return value;
    };
    int type = take();
    made->type = {type & 8 ? ChunkType::Kind::Signed : ChunkType::Kind::Unsigned, 1 << (type & 3), (type & 16) != 0};
    if ((type & 32) && made->type.bytes >= 4) made->type.kind = ChunkType::Kind::Float;
    for (int filters = take() & 3; filters > 0; --filters) {
      int id = take();
      made->filters.push_back({id >= 125 ? id - 125 + 32000 : id, "a filter"});
    }
    for (auto* sizes : {&made->shape, &made->chunk})
      for (int axis = 0; axis < 3; ++axis) sizes->push_back(std::uint64_t(take()));
    return made;
  }

 private:
  class Dataset : public Hdf5Dataset {
   public:
    Dataset(const FuzzHdf5& from, std::string name) : mFrom(from), mName(std::move(name)) {}
    std::optional<Hdf5Piece> find(std::span<const std::uint64_t> index) const override {
      std::string key = mName + "#";
      for (std::uint64_t number : index) key += (key.ends_with('#') ? "" : ".") + std::to_string(number);
      auto found = mFrom.mRecords.find(key);
      if (found == mFrom.mRecords.end()) return std::nullopt;
      return Hdf5Piece{mFrom.mFile, found->second.first, found->second.second, 0};
    }
    Bytes read(std::span<const std::uint64_t>, std::span<const std::uint64_t> size) const override {
      std::uint64_t bytes = std::uint64_t(type.bytes);
      for (std::uint64_t one : size) bytes *= one;
      return Bytes(static_cast<std::size_t>(bytes), std::byte(1));
    }

   private:
    const FuzzHdf5& mFrom;
    std::string mName;
  };
  static FuzzFile& file() {
    static FuzzFile file("a.h5");
    return file;
  }
  std::optional<std::string> bytesOfKey(const std::string& key) const {
    auto found = mRecords.find(key);
    if (found == mRecords.end()) return std::nullopt;
    std::string bytes(found->second.second, '\0');
    mFile->read(found->second.first, std::as_writable_bytes(std::span(bytes)));
    return bytes;
  }

  Path mPath;
  std::shared_ptr<const FileBytes> mFile;
  std::map<std::string, std::pair<std::size_t, std::size_t>> mRecords;
};

}  // namespace velum::io
