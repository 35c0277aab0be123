#include "io/stores/SpareBytes.h"

#include <algorithm>
#include <vector>

namespace velum::io {

namespace {

constexpr std::size_t kMostSpare = std::size_t(8) << 20, kMostPieces = 2;

std::vector<Bytes>& spares() {
  thread_local std::vector<Bytes> pieces;
  return pieces;
}

}  // namespace

Bytes takeBytes(std::size_t size) {
  auto& pieces = spares();
  auto fits = std::find_if(pieces.begin(), pieces.end(), [&](const Bytes& piece) { return piece.capacity() >= size; });
  if (fits == pieces.end()) return Bytes(size);
  Bytes bytes = std::move(*fits);
  pieces.erase(fits);
  bytes.resize(size);
  return bytes;
}

void giveBytes(Bytes&& bytes) {
  Bytes given = std::move(bytes);
  auto& pieces = spares();
  if (given.capacity() == 0 || given.capacity() > kMostSpare) return;
  if (pieces.size() == kMostPieces) pieces.erase(pieces.begin());
  pieces.push_back(std::move(given));
}

}  // namespace velum::io
