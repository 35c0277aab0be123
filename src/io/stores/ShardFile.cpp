#include "io/stores/ShardFile.h"

#include <fmt/format.h>
#include <zstd.h>

#include <cstdint>
#include <cstring>
#include <memory>

#include "core/Error.h"
#include "io/read/FileBytes.h"
#include "io/stores/Crc32c.h"

namespace velum::io {

namespace {

constexpr std::uint64_t kLeftOut = ~std::uint64_t(0);  ///< offset and size of a brick that is left out

struct Freed {
  void operator()(ZSTD_CCtx* context) const { ::ZSTD_freeCCtx(context); }
};

}  // namespace

Bytes packZstd(std::span<const std::byte> bytes, int level) {
  // Its tables are some megabytes: one for each thread, not for each brick; as for the bytes.
  thread_local std::unique_ptr<ZSTD_CCtx, Freed> context(::ZSTD_createCCtx());
  ::ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, level);
  ::ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
  thread_local Bytes most;
  most.resize(::ZSTD_compressBound(bytes.size()));
  std::size_t size = ::ZSTD_compress2(context.get(), most.data(), most.size(), bytes.data(), bytes.size());
  if (::ZSTD_isError(size)) throw InputError(fmt::format("zstd cannot pack: {}", ::ZSTD_getErrorName(size)));
  Bytes packed(size);
  std::memcpy(packed.data(), most.data(), size);
  return packed;
}

void writeShardFile(std::span<const Bytes> bricks, ReplaceFile& file) {
  std::vector<std::uint64_t> index;
  std::uint64_t at = 0;
  for (const Bytes& brick : bricks) {
    index.push_back(brick.empty() ? kLeftOut : at);
    index.push_back(brick.empty() ? kLeftOut : brick.size());
    at += brick.size();
    file.write(std::span(brick));
  }
  auto table = std::as_bytes(std::span(index));
  std::uint32_t sum = crc32c(table);
  file.write(table);
  file.write(std::as_bytes(std::span(&sum, 1)));
}

bool isWholeShard(const Path& path, std::size_t brickCount) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  FileBytes file(path);
  std::uint32_t sum = 0;
  std::vector<std::uint64_t> index(2 * brickCount);
  auto table = std::as_writable_bytes(std::span(index));
  if (file.size() < table.size() + sizeof(sum)) return false;
  std::uint64_t end = file.size() - table.size() - sizeof(sum), next = 0;
  file.read(end, table);
  file.read(end + table.size(), std::as_writable_bytes(std::span(&sum, 1)));
  if (crc32c(table) != sum) return false;
  for (std::size_t i = 0; i < brickCount; ++i) {
    if (index[2 * i] == kLeftOut) continue;
    if (index[2 * i] != next) return false;
    next += index[2 * i + 1];
  }
  return next == end;
}

}  // namespace velum::io
