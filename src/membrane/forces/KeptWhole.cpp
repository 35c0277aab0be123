#include "membrane/forces/KeptWhole.h"

#include <algorithm>
#include <cmath>

#include "membrane/forces/FrameBox.h"

#include "core/Assert.h"
#include "core/Parallel.h"

namespace velum::membrane {

namespace {

/// What is known of a voxel while pairs are counted.
constexpr std::uint8_t kProtected = 1, kAbovePlane = 2, kAboveSheet = 4, kInFrame = 8;

/// Sides of the protected voxels of a box.
struct Sides {
  VoxelBox box;
  glm::ivec3 size{0};
  std::vector<std::uint8_t> flags;  ///< [z][y][x]
  std::size_t at(int x, int y, int z) const {
    return (std::size_t(z) * std::size_t(size.y) + std::size_t(y)) * std::size_t(size.x) + std::size_t(x);
  }
};

/// Looks at one row: where its protected voxels are, and on which sides.
class RowOfSides {
 public:
  RowOfSides(const ProtectedVoxels& voxels, const scene::Cut& cut, const SideOfPoints& side)
      : mVoxels(voxels), mFrame(cut, voxels.worldFromVoxel), mSide(side) {}

  void fill(const Sides& sides, int y, int z, std::uint8_t* flags) const {
    glm::ivec3 from = sides.box.min - mVoxels.box.min, size = mVoxels.box.end - mVoxels.box.min;
    const std::uint8_t* mask =
        mVoxels.mask.data() + (std::ptrdiff_t(z + from.z) * size.y + y + from.y) * size.x + from.x;
    glm::dvec3 start = mFrame.local(glm::dvec3(sides.box.min + glm::ivec3(0, y, z)));
    glm::dvec3 step(mFrame.localFromVoxel[0]);
    thread_local std::vector<glm::vec3> points;
    thread_local std::vector<std::uint8_t> above;
    points.clear();
    for (int x = 0; x < sides.size.x; ++x) {
      flags[x] = mask[x] ? kProtected : 0;
      if (!mask[x]) continue;
      glm::dvec3 p = start + double(x) * step;
      if (mFrame.holds(p)) flags[x] |= kInFrame;
      p.z -= mFrame.hair;
      if (p.z > 0.0) flags[x] |= kAbovePlane;
      points.push_back(glm::vec3(p));
    }
    if (points.empty()) return;
    above.assign(points.size(), 0);
    mSide(points, above);
    std::size_t next = 0;
    for (int x = 0; x < sides.size.x; ++x)
      if (flags[x] & kProtected && above[next++]) flags[x] |= kAboveSheet;
  }

 private:
  const ProtectedVoxels& mVoxels;
  FrameBox mFrame;
  const SideOfPoints& mSide;
};

struct Areas {
  std::int64_t plane = 0, sheet = 0, above = 0, below = 0;
  void add(std::uint8_t a, std::uint8_t b) {
    bool counts = a & b & kProtected && (a | b) & kInFrame;
    std::uint8_t differs = counts ? a ^ b : 0;
    plane += (differs & kAbovePlane) != 0;
    sheet += (differs & kAboveSheet) != 0;
    if ((differs & kAbovePlane) == 0 || differs & kAboveSheet) return;
    (a & kAboveSheet ? above : below) += 1;
  }
};

Areas countPairs(const Sides& sides) {
  const auto& f = sides.flags;
  return parallelReduce(
      0, sides.size.z, 1, Areas(),
      [&](int first, int end) {
        Areas areas;
        for (int z = first; z < end; ++z)
          for (int y = 0; y < sides.size.y; ++y)
            for (int x = 0; x < sides.size.x; ++x) {
              std::uint8_t own = f[sides.at(x, y, z)];
              if (!own) continue;
              if (x + 1 < sides.size.x) areas.add(own, f[sides.at(x + 1, y, z)]);
              if (y + 1 < sides.size.y) areas.add(own, f[sides.at(x, y + 1, z)]);
              if (z + 1 < sides.size.z) areas.add(own, f[sides.at(x, y, z + 1)]);
            }
        return areas;
      },
      [](Areas a, const Areas& b) {
        a.plane += b.plane;
        a.sheet += b.sheet;
        a.above += b.above;
        a.below += b.below;
        return a;
      });
}

VoxelBox intersect(VoxelBox a, VoxelBox b) {
  glm::ivec3 low = glm::max(a.min, b.min);
  return {low, glm::max(low, glm::min(a.end, b.end))};
}

double triangleArea(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  return std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) * 0.5;
}

/// Mean of |z| over a triangle: of a linear function, cut at its zero line.
double meanAbsolute(double a, double b, double c) {
  double sum = (a + b + c) / 3.0;
  if ((a >= 0) == (b >= 0) && (b >= 0) == (c >= 0)) return std::abs(sum);
  // Let `a` be the corner on a side of its own: its tip has the share t of the area, and a third of a as its mean.
  if ((a >= 0) == (c >= 0)) std::swap(a, b);
  if ((a >= 0) == (b >= 0)) std::swap(a, c);
  double t = a * a / ((a - b) * (a - c));
  return std::abs(2.0 * t * a / 3.0 - sum);
}

}  // namespace

VoxelBox voxelsInReach(const Potential& potential, const scene::Cut& cut) {
  return voxelsInReach(potential.dims(), potential.worldFromVoxel(), cut);
}

VoxelBox voxelsInReach(glm::ivec3 dims, const glm::dmat4& worldFromVoxel, const scene::Cut& cut) {
  glm::dmat4 voxelFromLocal = glm::inverse(FrameBox(cut, worldFromVoxel).localFromVoxel);
  glm::dvec3 middle(voxelFromLocal[3]), half(0.0);
  for (int axis = 0; axis < 3; ++axis) half += glm::abs(glm::dvec3(voxelFromLocal[axis])) * cut.size[axis] * 0.5;
  // Clamped before they become integers: a frame may be far larger than the data.
  glm::dvec3 low = glm::clamp(glm::floor(middle - half) - 1.0, glm::dvec3(0.0), glm::dvec3(dims));
  glm::dvec3 high = glm::clamp(glm::ceil(middle + half) + 2.0, low, glm::dvec3(dims));
  return {glm::ivec3(low), glm::ivec3(high)};
}

KeptWhole measureKeptWhole(const ProtectedVoxels& voxels, const scene::Cut& cut, const SideOfPoints& side,
                           double meanDistance, Progress& progress) {
  VELUM_ASSERT(holdsItsBox(voxels), "each voxel of the box is decided");
  Sides sides;
  sides.box = intersect(voxelsInReach(voxels.box.end, voxels.worldFromVoxel, cut), voxels.box);
  sides.size = sides.box.end - sides.box.min;
  sides.flags.resize(std::size_t(sides.size.x) * std::size_t(sides.size.y) * std::size_t(sides.size.z));
  RowOfSides rows(voxels, cut, side);
  parallelFor(0, sides.size.y * sides.size.z, [&](int row) {
    if (progress.isCancelled()) return;
    int y = row % sides.size.y, z = row / sides.size.y;
    rows.fill(sides, y, z, sides.flags.data() + sides.at(0, y, z));
  });
  progress.throwIfCancelled();
  Areas areas = countPairs(sides);
  KeptWhole result{areas.plane, areas.sheet, 1.0, meanDistance, areas.above, areas.below, {}};
  if (areas.plane > 0 || areas.sheet > 0)
    result.ratio = double(areas.sheet) / double(std::max<std::int64_t>(areas.plane, 1));
  return result;
}

Shares sharesOf(const KeptWhole& figure, const scene::Cut& cut) {
  if (figure.cutAreaPlane == 0) return {};
  Shares shares;
  shares.cut = std::min(figure.ratio, 1.0);
  std::int64_t whole = figure.planeAbove + figure.planeBelow, gone = cut.invert ? figure.planeBelow : figure.planeAbove;
  shares.removed = whole > 0 ? (1.0 - shares.cut) * double(gone) / double(whole) : 0.0;
  shares.kept = 1.0 - shares.cut - shares.removed;
  return shares;
}

bool isWorseThanFlat(const KeptWhole& figure, const scene::Cut& cut) {
  const scene::Membrane& membrane = *cut.membrane;
  bool isHeld = !membrane.pins.empty() || !membrane.field.kernels.empty();
  return membrane.field.rule == scene::KernelRule::Sided && !isHeld && figure.cutAreaMembrane > figure.cutAreaPlane;
}

KeptWhole figureOfFlat(const KeptWhole& other) {
  return {other.cutAreaPlane, other.cutAreaPlane, 1.0, 0.0, 0, 0, other.fate};
}

double meanDistance(const scene::SheetShape& shape) {
  glm::ivec2 n = shape.particles;
  if (n.x < 2 || n.y < 2 || shape.places.size() != std::size_t(n.x) * std::size_t(n.y)) return 0.0;
  double weighted = 0.0, total = 0.0;
  auto add = [&](glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
    double area = triangleArea(a, b, c);
    weighted += area * meanAbsolute(a.z, b.z, c.z);
    total += area;
  };
  for (int y = 0; y + 1 < n.y; ++y)
    for (int x = 0; x + 1 < n.x; ++x) {
      const glm::vec3* p = shape.places.data() + std::ptrdiff_t(y) * n.x + x;
      add(glm::dvec3(p[0]), glm::dvec3(p[1]), glm::dvec3(p[n.x + 1]));
      add(glm::dvec3(p[0]), glm::dvec3(p[n.x + 1]), glm::dvec3(p[n.x]));
    }
  return total > 0.0 ? weighted / total : 0.0;
}

}  // namespace velum::membrane
