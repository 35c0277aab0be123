#include "io/meshes/StructureShares.h"

#include <algorithm>
#include <array>

namespace velum::io {

namespace {

constexpr int kSize = LabelVolume::kBrickSize;

}  // namespace

StructureShares::StructureShares(const StructureField& field, std::uint16_t structure, glm::ivec3 low, glm::ivec3 high)
    : mField(field), mStructure(structure) {
  const LabelVolume& labels = *field.cover().labels();
  // A normal looks at voxels one before a way's beginning to two behind it; a share at all voxels around its own.
  mShares.low = low - 1, mShares.size = high - low + 4;
  mShares.values.assign(std::size_t(mShares.size.x) * std::size_t(mShares.size.y) * std::size_t(mShares.size.z), 0.0f);
  mIds.low = mShares.low - 1, mIds.size = mShares.size + 2;
  fillIds();
  glm::ivec3 first = glm::max(mShares.low, glm::ivec3(0)) / kSize, brick;
  glm::ivec3 last = glm::min(mShares.low + mShares.size - 1, labels.dims() - 1) / kSize;
  for (brick.z = first.z; brick.z <= last.z; ++brick.z)
    for (brick.y = first.y; brick.y <= last.y; ++brick.y)
      for (brick.x = first.x; brick.x <= last.x; ++brick.x) fillShares(brick);
}

void StructureShares::fillIds() {
  const LabelVolume& labels = *mField.cover().labels();
  mIds.values.assign(std::size_t(mIds.size.x) * std::size_t(mIds.size.y) * std::size_t(mIds.size.z), 0);
  glm::ivec3 low = glm::max(mIds.low, glm::ivec3(0)), size = glm::min(mIds.low + mIds.size, labels.dims()) - low;
  std::vector<std::uint16_t> inGrid(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
  labels.read(low, size, inGrid);
  auto row = inGrid.begin();
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y, row += size.x)
      std::copy_n(row, size.x, mIds.values.begin() + std::ptrdiff_t(mIds.at(low + glm::ivec3(0, y, z))));
}

/// Shares in a brick of the labels, as far as they are asked for.
void StructureShares::fillShares(glm::ivec3 brick) {
  const LabelCover::Brick& cover = mField.brick(brick);
  glm::ivec3 corner = brick * kSize, low = glm::max(mShares.low, corner);
  glm::ivec3 end = glm::min(glm::min(mShares.low + mShares.size, corner + kSize), mField.cover().labels()->dims());
  for (int z = low.z; z < end.z; ++z)
    for (int y = low.y; y < end.y; ++y)
      for (int x = low.x; x < end.x; ++x) {
        glm::ivec3 voxel(x, y, z), in = voxel - corner;
        bool isOwn = idIn(voxel) == mStructure;
        int inside = cover.size() == 1 ? cover[0] : cover[std::size_t((in.z * kSize + in.y) * kSize + in.x)];
        float own = 0.5f + float(inside) * (0.5f / 255.0f);
        // The rest of a voxel may be any other's that is around it.
        mShares.values[mShares.at(voxel)] = isOwn ? own : inside < 255 && isBeside(voxel) ? 1.0f - own : 0.0f;
      }
}

bool StructureShares::isBeside(glm::ivec3 voxel) const {
  for (int n = 0; n < 27; ++n)
    if (idIn(voxel + glm::ivec3(n % 3, n / 3 % 3, n / 9) - 1) == mStructure) return true;
  return false;
}

bool StructureShares::hasThird(const BorderWay& way) const {
  glm::ivec3 u = unitAlong((way.axis + 1) % 3), v = unitAlong((way.axis + 2) % 3), to = way.to();
  std::uint16_t a = idIn(way.from), b = idIn(to);
  for (int i = -1; i <= 1; ++i)
    for (int k = -1; k <= 1; ++k)
      for (glm::ivec3 end : {way.from, to})
        if (std::uint16_t id = idIn(end + i * u + k * v); id != a && id != b) return true;
  return false;
}

double StructureShares::partOf(const BorderWay& way) const {
  double a = shareOf(way.from), b = shareOf(way.to());
  bool leavesGrid = a == 0.0 || b == 0.0;  // one is the structure's, and what is beside it has a share
  return leavesGrid || hasThird(way) ? io::partOf(mField, way) : (a - 0.5) / (a - b);
}

/// Differences across the corners of a cube about the place, as pictures take them: of what was tried the nearest to
/// the true normals of balls and tubes.
glm::dvec3 StructureShares::normalAt(const BorderWay& way, double part) const {
  constexpr double kAcross[] = {0.25, 0.5, 0.25}, kSlope[] = {-0.5, 0.0, 0.5};
  glm::ivec3 along = unitAlong(way.axis), u = unitAlong((way.axis + 1) % 3), v = unitAlong((way.axis + 2) % 3);
  // Weights of the four voxels of a row in the place half a voxel before, and in that half a voxel behind.
  std::size_t first = part < 0.5 ? 0 : 1;
  double rest = part < 0.5 ? part + 0.5 : part - 0.5;
  std::array<double, 4> before{}, behind{};
  before[first] = 1.0 - rest, before[first + 1] = rest;
  behind[first + 1] = 1.0 - rest, behind[first + 2] = rest;
  glm::dvec3 rise(0.0);  // along, u, v
  for (int j = 0; j < 3; ++j)
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < 4; ++i) {
        double share = shareOf(way.from + (i - 1) * along + (j - 1) * u + (k - 1) * v);
        double near = before[std::size_t(i)], far = behind[std::size_t(i)], mean = 0.5 * (near + far);
        rise += share * glm::dvec3((far - near) * kAcross[j] * kAcross[k], mean * kSlope[j] * kAcross[k],
                                   mean * kAcross[j] * kSlope[k]);
      }
  glm::dvec3 out = -(rise.x * glm::dvec3(along) + rise.y * glm::dvec3(u) + rise.z * glm::dvec3(v));
  double length = glm::length(out);
  return length > 0.0 ? out / length : out;
}

}  // namespace velum::io
