#include "membrane/forces/Fate.h"

#include <cstddef>
#include <vector>

#include "core/Assert.h"
#include "core/Parallel.h"
#include "membrane/forces/FrameBox.h"

namespace velum::membrane {

namespace {

/// Where less than this of a piece stays it is gone as a whole: what is left is a scrap at its end.
constexpr double kScrap = 0.02;
constexpr std::uint8_t kFree = 0, kStays = 1, kGoes = 2, kSeen = 3;

/// For each voxel whether it is protected, and then whether it stays.
std::vector<std::uint8_t> sidesOf(const ProtectedVoxels& voxels, const scene::Cut& cut, const SideOfPoints& side,
                                  const Progress& progress) {
  FrameBox frame(cut, voxels.worldFromVoxel);
  glm::ivec3 size = voxels.box.end - voxels.box.min;
  std::vector<std::uint8_t> sides(voxels.mask.size(), kFree);
  parallelFor(0, size.z, [&](int z) {
    if (progress.isCancelled()) return;
    std::vector<glm::vec3> points;
    std::vector<std::size_t> places;
    std::size_t i = std::size_t(z) * std::size_t(size.y) * std::size_t(size.x);
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x, ++i) {
        if (!voxels.mask[i]) continue;
        glm::dvec3 p = frame.local(glm::dvec3(voxels.box.min + glm::ivec3(x, y, z)));
        p.z -= frame.hair;
        points.emplace_back(p);
        places.push_back(i);
      }
    std::vector<std::uint8_t> above(points.size(), 0);
    side(points, above);
    for (std::size_t k = 0; k < places.size(); ++k) sides[places[k]] = (above[k] != 0) == cut.invert ? kStays : kGoes;
  });
  progress.throwIfCancelled();
  return sides;
}

/// Voxels of a piece on either side.
struct Piece {
  std::size_t stays = 0, goes = 0;
};

/// Goes through the piece that a voxel belongs to.
Piece takePiece(std::vector<std::uint8_t>& sides, glm::ivec3 size, std::size_t first,
                std::vector<std::size_t>& waiting) {
  Piece piece;
  auto nx = std::size_t(size.x), ny = std::size_t(size.y);
  auto look = [&](std::size_t at) {
    if (sides[at] == kFree || sides[at] == kSeen) return;
    (sides[at] == kStays ? piece.stays : piece.goes) += 1;
    sides[at] = kSeen;
    waiting.push_back(at);
  };
  waiting.clear();
  look(first);
  while (!waiting.empty()) {
    std::size_t at = waiting.back(), x = at % nx, y = at / nx % ny, z = at / (nx * ny);
    waiting.pop_back();
    if (x > 0) look(at - 1);
    if (x + 1 < nx) look(at + 1);
    if (y > 0) look(at - nx);
    if (y + 1 < ny) look(at + nx);
    if (z > 0) look(at - nx * ny);
    if (z + 1 < std::size_t(size.z)) look(at + nx * ny);
  }
  return piece;
}

}  // namespace

Fate measureFate(const ProtectedVoxels& voxels, const scene::Cut& cut, const SideOfPoints& side, Progress& progress) {
  VELUM_ASSERT(holdsItsBox(voxels), "each voxel of the box is decided");
  glm::ivec3 size = voxels.box.end - voxels.box.min;
  std::vector<std::uint8_t> sides = sidesOf(voxels, cut, side, progress);
  std::size_t stays = 0, removed = 0, cutOff = 0;
  std::vector<std::size_t> waiting;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (sides[i] == kFree || sides[i] == kSeen) continue;
    progress.throwIfCancelled();
    Piece piece = takePiece(sides, size, i, waiting);
    stays += piece.stays;
    bool isScrap = double(piece.stays) < kScrap * double(piece.stays + piece.goes);
    (isScrap ? removed : cutOff) += piece.goes;
  }
  auto all = double(stays + removed + cutOff);
  if (all == 0.0) return {};
  return {double(stays) / all, double(removed) / all, double(cutOff) / all, true};
}

SideOfPoints sideOfPlane() {
  return [](std::span<const glm::vec3> local, std::span<std::uint8_t> above) {
    for (std::size_t i = 0; i < local.size(); ++i) above[i] = local[i].z > 0.0f;
  };
}

}  // namespace velum::membrane
