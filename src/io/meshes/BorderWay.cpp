#include "io/meshes/BorderWay.h"

namespace velum::io {

namespace {

constexpr int kSize = LabelVolume::kBrickSize;
constexpr double kBeside = 1e-4;  ///< voxels off a way at which what lies beside it counts, and where it lies does not
constexpr int kHalvings = 12;     ///< to a four thousandth of a voxel

bool isInGrid(const StructureField& field, glm::ivec3 voxel) {
  return glm::all(glm::greaterThanEqual(voxel, glm::ivec3(0))) &&
         glm::all(glm::lessThan(voxel, field.cover().labels()->dims()));
}

double coverAt(const StructureField& field, glm::ivec3 voxel) {
  const LabelCover::Brick& cover = field.brick(voxel / kSize);
  glm::ivec3 in = voxel % kSize;
  return cover.size() == 1 ? cover[0] : cover[std::size_t((in.z * kSize + in.y) * kSize + in.x)];
}

/// Which side of a way has a voxel of another structure in a cell that the way bounds; zero: none.
glm::ivec3 otherBeside(const StructureField& field, const BorderWay& way, std::uint16_t labelled) {
  glm::ivec3 u = unitAlong((way.axis + 1) % 3), v = unitAlong((way.axis + 2) % 3);
  for (int i = -1; i <= 1; ++i)
    for (int k = -1; k <= 1; ++k)
      for (glm::ivec3 end : {way.from, way.to()}) {
        glm::ivec3 side = i * u + k * v;
        std::uint16_t id = idAt(field, end + side);
        if (id != 0 && id != labelled) return side;
      }
  return glm::ivec3(0);
}

/// Where several structures meet what has no label all of them together decide who ends where: on the way itself only
/// two are heard, so it is asked just beside it.
double partBeside(const StructureField& field, const BorderWay& way, glm::ivec3 side) {
  bool startsLabelled = idAt(field, way.from) != 0;
  double low = 0.0, high = 1.0;
  for (int i = 0; i < kHalvings; ++i) {
    double middle = 0.5 * (low + high);
    bool isLabelled = field.at(way.at(middle) + kBeside * glm::dvec3(side)).id != 0;
    (isLabelled == startsLabelled ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

glm::ivec3 unitAlong(int axis) {
  glm::ivec3 unit(0);
  unit[axis] = 1;
  return unit;
}

glm::ivec3 BorderWay::to() const { return from + unitAlong(axis); }

glm::dvec3 BorderWay::at(double part) const { return glm::dvec3(from) + part * glm::dvec3(unitAlong(axis)); }

double partOf(const StructureField& field, const BorderWay& way) {
  if (!isInGrid(field, way.from) || !isInGrid(field, way.to())) return 0.5;
  std::uint16_t from = idAt(field, way.from), to = idAt(field, way.to());
  if (from == 0 || to == 0)
    if (glm::ivec3 side = otherBeside(field, way, std::max(from, to)); side != glm::ivec3(0))
      return partBeside(field, way, side);
  // Two have votes, each its cover times what is left of the way.
  double a = coverAt(field, way.from), b = coverAt(field, way.to());
  return a / (a + b);
}

}  // namespace velum::io
