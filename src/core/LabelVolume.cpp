#include "core/LabelVolume.h"

#include <algorithm>
#include <bitset>
#include <memory>

#include "core/Assert.h"
#include "core/Error.h"

namespace velum {

namespace {

constexpr int kEdge = LabelVolume::kBrickSize;
constexpr std::size_t kBrickVoxels = std::size_t(kEdge) * kEdge * kEdge;

std::size_t placeInBrick(glm::ivec3 v) {
  return (std::size_t(v.z) * kEdge + std::size_t(v.y)) * kEdge + std::size_t(v.x);
}

}  // namespace

LabelVolume::LabelVolume(glm::ivec3 dims, const glm::dmat4& worldFromVoxel, LengthUnit unit)
    : mDims(dims), mWorldFromVoxel(worldFromVoxel), mLengthUnit(unit) {
  if (dims.x < 1 || dims.y < 1 || dims.z < 1)
    throw ArgumentError("a label volume needs at least one voxel along each axis");
  mBricks = BrickTable<Shared<Brick>>((dims + kEdge - 1) / kEdge, Shared<Brick>(Brick{0}));
}

const LabelVolume::Brick& LabelVolume::brick(glm::ivec3 index) const { return *mBricks[index]; }

std::uint64_t LabelVolume::brickId(glm::ivec3 index) const { return mBricks[index].id(); }

void LabelVolume::setLengthUnit(LengthUnit unit) {
  double factor = unitsPer(mLengthUnit, unit);
  for (int column = 0; column < 4; ++column)
    mWorldFromVoxel[column] = glm::dvec4(glm::dvec3(mWorldFromVoxel[column]) * factor, mWorldFromVoxel[column].w);
  mLengthUnit = unit;
}

std::uint16_t LabelVolume::at(glm::ivec3 v) const {
  if (v.x < 0 || v.y < 0 || v.z < 0 || v.x >= mDims.x || v.y >= mDims.y || v.z >= mDims.z) return 0;
  const Brick& b = brick(v / kEdge);
  return b.size() == 1 ? b[0] : b[placeInBrick(v % kEdge)];
}

void LabelVolume::write(glm::ivec3 origin, glm::ivec3 size, std::span<const std::uint16_t> ids) {
  glm::ivec3 end = origin + size;
  if (glm::any(glm::lessThan(origin, glm::ivec3(0))) || glm::any(glm::greaterThan(end, mDims)))
    throw ArgumentError("the box to write leaves the label volume");
  if (ids.size() < std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z))
    throw ArgumentError("too few labels for the box to write");
  if (size.x < 1 || size.y < 1 || size.z < 1) return;
  glm::ivec3 first = origin / kEdge, last = (end - 1) / kEdge;
  for (int bz = first.z; bz <= last.z; ++bz)
    for (int by = first.y; by <= last.y; ++by)
      for (int bx = first.x; bx <= last.x; ++bx) {
        // Unfold the brick, overwrite the part inside the box, fold it again if one id is left.
        glm::ivec3 corner = glm::ivec3(bx, by, bz) * kEdge;
        const Brick& before = brick({bx, by, bz});
        Brick b = before.size() == 1 ? Brick(kBrickVoxels, before[0]) : before;
        glm::ivec3 low = glm::max(origin, corner), high = glm::min(end, corner + kEdge);
        for (int z = low.z; z < high.z; ++z)
          for (int y = low.y; y < high.y; ++y) {
            std::size_t from =
                (std::size_t(z - origin.z) * std::size_t(size.y) + std::size_t(y - origin.y)) * std::size_t(size.x) +
                std::size_t(low.x - origin.x);
            std::copy_n(ids.data() + from, high.x - low.x,
                        b.begin() + std::ptrdiff_t(placeInBrick(glm::ivec3(low.x, y, z) - corner)));
          }
        // Voxels of an edge brick that lie outside the grid take the brick's first id, so that they never keep it
        // unfolded.
        glm::ivec3 inside = glm::min(mDims - corner, glm::ivec3(kEdge));
        bool uniform = true;
        for (int z = 0; z < inside.z && uniform; ++z)
          for (int y = 0; y < inside.y && uniform; ++y) {
            auto row = b.begin() + std::ptrdiff_t(placeInBrick({0, y, z}));
            uniform = std::all_of(row, row + inside.x, [&](std::uint16_t id) { return id == b[0]; });
          }
        if (uniform) b = Brick{b[0]};
        if (b != before) mBricks.put({bx, by, bz}, Shared<Brick>(std::move(b)));
      }
}

void LabelVolume::fillBrick(glm::ivec3 index, std::uint16_t id) {
  const Brick& before = brick(index);
  if (before.size() > 1 || before[0] != id) mBricks.put(index, Shared<Brick>(Brick{id}));
}

void LabelVolume::read(glm::ivec3 origin, glm::ivec3 size, std::span<std::uint16_t> ids) const {
  glm::ivec3 end = origin + size;
  if (glm::any(glm::lessThan(origin, glm::ivec3(0))) || glm::any(glm::greaterThan(end, mDims)))
    throw ArgumentError("the box to read leaves the label volume");
  if (ids.size() < std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z))
    throw ArgumentError("too little room for the box to read");
  for (int z = origin.z; z < end.z; ++z)
    for (int y = origin.y; y < end.y; ++y) {
      std::size_t to =
          (std::size_t(z - origin.z) * std::size_t(size.y) + std::size_t(y - origin.y)) * std::size_t(size.x);
      for (int x = origin.x; x < end.x;) {
        glm::ivec3 index = glm::ivec3(x, y, z) / kEdge;
        int run = std::min(end.x, (index.x + 1) * kEdge) - x;
        const Brick& b = brick(index);
        if (b.size() == 1)
          std::fill_n(ids.begin() + std::ptrdiff_t(to), run, b[0]);
        else
          std::copy_n(b.begin() + std::ptrdiff_t(placeInBrick(glm::ivec3(x, y, z) - index * kEdge)), run,
                      ids.begin() + std::ptrdiff_t(to));
        to += std::size_t(run);
        x += run;
      }
    }
}

std::size_t LabelVolume::storedBytes() const {
  std::size_t bytes = 0;
  glm::ivec3 grid = brickGrid(), at;
  for (at.z = 0; at.z < grid.z; ++at.z)
    for (at.y = 0; at.y < grid.y; ++at.y)
      for (at.x = 0; at.x < grid.x; ++at.x)
        if (const Brick& b = brick(at); b.size() > 1) bytes += b.size() * sizeof(std::uint16_t);
  return bytes;
}

std::vector<std::uint16_t> LabelVolume::idsInUse() const {
  auto used = std::make_unique<std::bitset<65536>>();
  glm::ivec3 grid = brickGrid();
  for (int bz = 0; bz < grid.z; ++bz)
    for (int by = 0; by < grid.y; ++by)
      for (int bx = 0; bx < grid.x; ++bx) {
        const Brick& b = brick({bx, by, bz});
        glm::ivec3 inside =
            b.size() == 1 ? glm::ivec3(1) : glm::min(mDims - glm::ivec3(bx, by, bz) * kEdge, glm::ivec3(kEdge));
        for (int z = 0; z < inside.z; ++z)
          for (int y = 0; y < inside.y; ++y)
            for (int x = 0; x < inside.x; ++x) used->set(b.size() == 1 ? b[0] : b[placeInBrick({x, y, z})]);
      }
  std::vector<std::uint16_t> ids;
  for (int id = 1; id < 65536; ++id)
    if (used->test(std::size_t(id))) ids.push_back(std::uint16_t(id));
  return ids;
}

glm::vec3 defaultLabelColor(std::uint16_t id) {
  // Okabe and Ito's eight without black, then the same hues lightened or darkened by the turn.
  static constexpr float kBase[][3] = {{0.90f, 0.62f, 0.00f}, {0.34f, 0.71f, 0.91f}, {0.00f, 0.62f, 0.45f},
                                       {0.94f, 0.89f, 0.26f}, {0.00f, 0.45f, 0.70f}, {0.84f, 0.37f, 0.00f},
                                       {0.80f, 0.47f, 0.65f}};
  constexpr int kCount = 7;
  if (id == 0) return glm::vec3(0.0f);
  const float* base = kBase[(id - 1) % kCount];
  glm::vec3 color(base[0], base[1], base[2]);
  int turn = ((id - 1) / kCount) % 4;
  if (turn == 1) return glm::mix(color, glm::vec3(1.0f), 0.4f);
  if (turn == 2) return color * 0.65f;
  if (turn == 3) return glm::mix(color, glm::vec3(0.6f), 0.45f);
  return color;
}

}  // namespace velum
