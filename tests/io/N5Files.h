#pragma once
#include <bzlib.h>
#include <lzma.h>

#include "ZarrFiles.h"

/// Writes N5 as its description says, in the plainest way: what the readers are held against.
namespace velum::io {

/// Java's LZ4BlockOutputStream with blocks of 64 bytes, so that there are several; the first is stored as it is.
inline std::string packedByJavaLz4(const std::string& bytes) {
  std::string out;
  auto block = [&](char method, const std::string& packed, std::size_t size) {
    out += "LZ4Block" + std::string(1, method) + bytesOfNumber(std::uint32_t(packed.size())) +
           bytesOfNumber(std::uint32_t(size)) + std::string(4, '\x55') + packed;
  };
  constexpr std::size_t kBlock = 64;
  for (std::size_t at = 0; at < bytes.size(); at += kBlock) {
    std::string piece = bytes.substr(at, kBlock);
    if (at == 0)
      block(0x10 | 6, piece, piece.size());
    else
      block(0x20 | 6, packedBy("lz4", piece, 1).substr(4), piece.size());
  }
  block(0x10 | 6, "", 0);
  return out;
}

inline std::string packedForN5(const std::string& codec, const std::string& bytes, int sampleSize) {
  if (codec == "bzip2") {
    std::string packed(bytes.size() * 2 + 1024, '\0');
    auto size = unsigned(packed.size());
    ::BZ2_bzBuffToBuffCompress(packed.data(), &size, const_cast<char*>(bytes.data()), unsigned(bytes.size()), 9, 0, 0);
    packed.resize(size);
    return packed;
  }
  if (codec == "xz") {
    std::string packed(bytes.size() * 2 + 1024, '\0');
    std::size_t size = 0;
    ::lzma_easy_buffer_encode(6, LZMA_CHECK_CRC64, nullptr, reinterpret_cast<const std::uint8_t*>(bytes.data()),
                              bytes.size(), reinterpret_cast<std::uint8_t*>(packed.data()), &size, packed.size());
    packed.resize(size);
    return packed;
  }
  if (codec == "lz4") return packedByJavaLz4(bytes);
  return packedBy(codec, bytes, sampleSize);
}

/// A dataset that is to be written. Lists begin with x.
struct N5File {
  std::filesystem::path folder;
  Sizes shape, block;
  std::string type = "uint16", codec = "raw";
  bool tellsCount = false;     ///< mode 1
  Json more = Json::object();  ///< attributes besides
  std::function<double(const Sizes&)> value;
  std::function<bool(const Sizes&)> isThere = [](auto&) { return true; };  ///< a block, by its index

  std::string blockBytes(const Sizes& index) const;
  void write() const;
};

/// As of a sample's number, in an array whose x is fastest.
inline Sizes reversed(Sizes sizes) {
  std::reverse(sizes.begin(), sizes.end());
  return sizes;
}

inline std::string N5File::blockBytes(const Sizes& index) const {
  Sizes size;
  for (std::size_t i = 0; i < shape.size(); ++i) size.push_back(std::min(block[i], shape[i] - index[i] * block[i]));
  std::string head = bytesOfNumber(std::uint16_t(tellsCount), true) + bytesOfNumber(std::uint16_t(shape.size()), true);
  std::uint32_t count = 1;
  for (std::uint64_t one : size) {
    head += bytesOfNumber(std::uint32_t(one), true);
    count *= std::uint32_t(one);
  }
  if (tellsCount) head += bytesOfNumber(count, true);
  std::string bytes;
  forEach(reversed(size), [&](const Sizes& slowestFirst) {
    Sizes sample = reversed(slowestFirst);
    for (std::size_t i = 0; i < sample.size(); ++i) sample[i] += index[i] * block[i];
    bytes += sampleBytes(type, value(sample), true);
  });
  return head + packedForN5(codec, bytes, int(sampleBytes(type, 0, false).size()));
}

inline void N5File::write() const {
  std::filesystem::create_directories(folder);
  Json attributes = {{"dimensions", shape},
                     {"blockSize", block},
                     {"dataType", type},
                     {"compression", {{"type", codec == "zlib" ? "gzip" : codec}}}};
  attributes.update(more);
  writeBytes(folder / "attributes.json", attributes.dump());
  forEach(divided(shape, block), [&](const Sizes& index) {
    if (!isThere(index)) return;
    std::filesystem::path path = folder;
    for (std::uint64_t number : index) path /= std::to_string(number);
    std::filesystem::create_directories(path.parent_path());
    writeBytes(path, blockBytes(index));
  });
}

/// A dataset of x, y, z whose values are the numbers of its samples.
inline N5File n5Ramp(const std::filesystem::path& folder) {
  N5File file;
  file.folder = folder;
  file.shape = {7, 6, 5};
  file.block = {4, 3, 2};
  file.value = [](const Sizes& i) { return double(i[2] * 42 + i[1] * 7 + i[0]); };
  return file;
}

}  // namespace velum::io
