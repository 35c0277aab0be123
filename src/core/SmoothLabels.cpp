#include "core/SmoothLabels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bitset>
#include <cmath>
#include <map>
#include <mutex>

#include "core/Error.h"
#include "core/LabelCover.h"
#include "core/Parallel.h"

namespace velum {

namespace {

constexpr int kSize = LabelVolume::kBrickSize;
constexpr double kReach = 2.5;  ///< of the Gaussian, in standard deviations
/// On a surface that bends, the border of the Gaussian of a Gaussian lies twice as far inside as the Gaussian's, where
/// its slope is 1 / sqrt(2) as steep: with 1 / (sqrt(2) - 1) of their difference added the two cancel.
constexpr float kSharpen = 2.414f;
constexpr float kThin = 0.85f;        ///< share of the largest nearby from which on a voxel keeps its structure
constexpr double kLeastBlock = 1.4;   ///< voxels
constexpr double kLargestBlock = 16;  ///< voxels
constexpr std::size_t kFewestSteps = 8;

std::size_t countOf(glm::ivec3 size) { return std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z); }

/// A box of voxels, x fastest.
struct Box {
  glm::ivec3 size{0};
  std::vector<float> values;
  explicit Box(glm::ivec3 s) : size(s), values(countOf(s)) {}
  std::size_t at(glm::ivec3 p) const {
    return (std::size_t(p.z) * std::size_t(size.y) + std::size_t(p.y)) * std::size_t(size.x) + std::size_t(p.x);
  }
};

/// Half of a Gaussian, its middle first; all of it sums to 1.
std::vector<float> gaussian(double deviation) {
  int reach = int(std::ceil(kReach * deviation));
  std::vector<float> half(std::size_t(reach) + 1);
  double sum = 0.0;
  for (int i = 0; i <= reach; ++i) {
    double weight = deviation > 0.0 ? std::exp(-0.5 * i * i / (deviation * deviation)) : 1.0;
    half[std::size_t(i)] = float(weight);
    sum += i == 0 ? weight : 2.0 * weight;
  }
  for (float& weight : half) weight /= float(sum);
  return half;
}

/// Combines each value with those before and after it along an axis, up to `reach` away, where these are in the box.
template <class Join>
Box alongAxis(const Box& from, int axis, int reach, const Join& join) {
  if (reach == 0) return from;
  Box to(from.size);
  std::size_t step = axis == 0   ? 1
                     : axis == 1 ? std::size_t(from.size.x)
                                 : std::size_t(from.size.x) * std::size_t(from.size.y);
  int last = from.size[axis] - 1;
  for (int z = 0; z < from.size.z; ++z)
    for (int y = 0; y < from.size.y; ++y) {
      std::size_t row = from.at({0, y, z});
      if (axis == 0) {
        for (int x = 0; x < from.size.x; ++x) {
          float& out = to.values[row + std::size_t(x)];
          out = join(0, 0.0f, from.values[row + std::size_t(x)]);
          for (int i = 1; i <= reach; ++i) {
            out = join(i, out, from.values[row + std::size_t(std::max(x - i, 0))]);
            out = join(i, out, from.values[row + std::size_t(std::min(x + i, last))]);
          }
        }
        continue;
      }
      int here = axis == 1 ? y : z;
      float* out = &to.values[row];
      auto add = [&](int i, int there) {
        const float* in = &from.values[row - std::size_t(here) * step + std::size_t(there) * step];
        for (int x = 0; x < from.size.x; ++x) out[x] = join(i, out[x], in[x]);
      };
      add(0, here);
      for (int i = 1; i <= reach; ++i) add(i, std::max(here - i, 0)), add(i, std::min(here + i, last));
    }
  return to;
}

Box blurred(Box box, const std::array<std::vector<float>, 3>& kernels) {
  for (int axis : {2, 1, 0}) {
    const std::vector<float>& kernel = kernels[std::size_t(axis)];
    box = alongAxis(box, axis, int(kernel.size()) - 1,
                    [&](int i, float sum, float value) { return sum + kernel[std::size_t(i)] * value; });
  }
  return box;
}

/// The largest value up to `reach` away along each axis.
Box largestNear(Box box, glm::ivec3 reach) {
  for (int axis : {2, 1, 0})
    box = alongAxis(box, axis, reach[axis],
                    [](int i, float most, float value) { return i == 0 ? value : std::max(most, value); });
  return box;
}

/// The shape of one structure in a box: its smoothed share of each voxel, and the largest share nearby.
struct Shape {
  std::uint16_t id;
  Box share, near;
};

/// One brick with as much around it as its smoothed labels depend on.
class BrickSmoothing {
 public:
  BrickSmoothing(const LabelVolume& labels, std::span<const ShapeSmoothing> smoothings)
      : mLabels(labels), mSmoothings(smoothings) {
    for (int axis = 0; axis < 3; ++axis) mSpacing[axis] = glm::length(glm::dvec3(labels.worldFromVoxel()[axis]));
    glm::dvec3 widest(0.0);
    for (const ShapeSmoothing& one : smoothings) widest = glm::max(widest, deviationOf(one));
    mHalo = 2 * reachOf(widest) + nearOf(widest);
  }

  /// @return nothing where the brick stays as it is
  std::vector<std::uint16_t> run(glm::ivec3 index) const {
    glm::ivec3 corner = index * kSize, core = glm::min(mLabels.dims() - corner, glm::ivec3(kSize));
    glm::ivec3 size = core + 2 * mHalo;
    if (isUniform(corner - mHalo, size)) return {};
    std::vector<std::uint16_t> ids = readAround(mLabels, corner - mHalo, size);
    std::vector<const ShapeSmoothing*> here = smoothedIn(ids);
    if (here.empty()) return {};
    std::vector<Shape> shapes = shapesOf(here, ids, size);
    std::vector<std::uint16_t> out(countOf(core));
    std::size_t i = 0;
    for (int z = 0; z < core.z; ++z)
      for (int y = 0; y < core.y; ++y)
        for (int x = 0; x < core.x; ++x, ++i) {
          std::size_t at = shapes[0].share.at(mHalo + glm::ivec3(x, y, z));
          out[i] = isFree(ids[at]) ? ownerOf(shapes, ids[at], at) : ids[at];
        }
    return out;
  }

 private:
  glm::dvec3 deviationOf(const ShapeSmoothing& one) const {
    return glm::min(glm::dvec3(one.deviation) / mSpacing, glm::dvec3(kWidestSmoothing));
  }
  static glm::ivec3 reachOf(glm::dvec3 deviation) { return glm::ivec3(glm::ceil(kReach * deviation)); }
  static glm::ivec3 nearOf(glm::dvec3 deviation) { return glm::ivec3(glm::ceil(deviation)); }

  const ShapeSmoothing* smoothingOf(std::uint16_t id) const {
    auto found = std::lower_bound(mSmoothings.begin(), mSmoothings.end(), id,
                                  [](const ShapeSmoothing& one, std::uint16_t other) { return one.id < other; });
    return found != mSmoothings.end() && found->id == id ? &*found : nullptr;
  }
  bool isFree(std::uint16_t id) const { return id == 0 || smoothingOf(id); }

  bool isUniform(glm::ivec3 low, glm::ivec3 size) const {
    glm::ivec3 first = glm::max(low, glm::ivec3(0)) / kSize;
    glm::ivec3 last = glm::min(low + size - 1, mLabels.dims() - 1) / kSize, at;
    std::uint16_t id = mLabels.brick(first)[0];
    for (at.z = first.z; at.z <= last.z; ++at.z)
      for (at.y = first.y; at.y <= last.y; ++at.y)
        for (at.x = first.x; at.x <= last.x; ++at.x)
          if (const auto& brick = mLabels.brick(at); brick.size() > 1 || brick[0] != id) return false;
    return true;
  }

  std::vector<const ShapeSmoothing*> smoothedIn(const std::vector<std::uint16_t>& ids) const {
    std::vector<std::uint16_t> found;
    std::uint16_t last = 0;
    for (std::uint16_t id : ids)
      if (id != last && std::find(found.begin(), found.end(), id) == found.end())
        found.push_back(last = id);
      else
        last = id;
    std::sort(found.begin(), found.end());
    std::vector<const ShapeSmoothing*> smoothed;
    for (std::uint16_t id : found)
      if (const ShapeSmoothing* one = smoothingOf(id)) smoothed.push_back(one);
    return smoothed;
  }

  /// Those of the named structures, and after them that of what has no label.
  std::vector<Shape> shapesOf(const std::vector<const ShapeSmoothing*>& here, const std::vector<std::uint16_t>& ids,
                              glm::ivec3 size) const {
    Box free(size), nobody(size);
    bool isAllFree = true;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      free.values[i] = isFree(ids[i]) ? 1.0f : 0.0f;
      isAllFree &= free.values[i] > 0.0f;
    }
    std::fill(nobody.values.begin(), nobody.values.end(), 1.0f);
    std::vector<Shape> shapes;
    glm::ivec3 widest(0);
    for (const ShapeSmoothing* one : here) {
      glm::dvec3 deviation = deviationOf(*one);
      widest = glm::max(widest, nearOf(deviation));
      std::array<std::vector<float>, 3> kernels{gaussian(deviation.x), gaussian(deviation.y), gaussian(deviation.z)};
      Box mask(size);
      for (std::size_t i = 0; i < ids.size(); ++i) mask.values[i] = ids[i] == one->id ? 1.0f : 0.0f;
      Box share = isAllFree ? shareOf(std::move(mask), kernels) : shareOf(std::move(mask), free, kernels);
      for (std::size_t i = 0; i < ids.size(); ++i) nobody.values[i] -= share.values[i];
      Box near = largestNear(share, nearOf(deviation));
      shapes.push_back({one->id, std::move(share), std::move(near)});
    }
    Box near = largestNear(nobody, widest);
    shapes.push_back({0, std::move(nobody), std::move(near)});
    return shapes;
  }

  static Box sharpened(Box once, const Box& twice) {
    for (std::size_t i = 0; i < once.values.size(); ++i)
      once.values[i] += kSharpen * (once.values[i] - twice.values[i]);
    return once;
  }
  static Box shareOf(Box mask, const std::array<std::vector<float>, 3>& kernels) {
    Box once = blurred(std::move(mask), kernels);
    return sharpened(once, blurred(once, kernels));
  }
  /// Of what is free alone.
  static Box shareOf(Box mask, const Box& free, const std::array<std::vector<float>, 3>& kernels) {
    auto blurredFree = [&](Box box) {
      for (std::size_t i = 0; i < box.values.size(); ++i) box.values[i] *= free.values[i];
      return blurred(std::move(box), kernels);
    };
    Box weight = blurredFree(free);
    auto average = [&](Box box) {
      box = blurredFree(std::move(box));
      for (std::size_t i = 0; i < box.values.size(); ++i)
        box.values[i] = weight.values[i] > 1e-6f ? box.values[i] / weight.values[i] : 0.0f;
      return box;
    };
    Box once = average(std::move(mask));
    return sharpened(once, average(once));
  }

  static std::uint16_t ownerOf(const std::vector<Shape>& shapes, std::uint16_t own, std::size_t at) {
    const Shape* best = nullptr;
    for (const Shape& shape : shapes) {
      float share = shape.share.values[at];
      if (shape.id == own && share >= std::min(0.5f, kThin * shape.near.values[at])) return own;
      if (!best || share > best->share.values[at] || (share == best->share.values[at] && shape.id == own))
        best = &shape;
    }
    return best->id;
  }

  const LabelVolume& mLabels;
  std::span<const ShapeSmoothing> mSmoothings;
  glm::dvec3 mSpacing{1.0};
  glm::ivec3 mHalo{0};
};

/// Where along each axis a structure has steps to what has no label: planes between a voxel and the one before it. Its
/// borders to others may be theirs.
using Steps = std::array<std::vector<int>, 3>;

/// The steps in one brick, by structure; bit i of an axis is the plane before its voxel i.
using BrickSteps = std::map<std::uint16_t, std::array<std::bitset<kSize>, 3>>;

BrickSteps stepsIn(const LabelVolume& labels, glm::ivec3 corner) {
  constexpr int kWide = kSize + 1;
  std::vector<std::uint16_t> ids = readAround(labels, corner - 1, glm::ivec3(kWide));
  glm::ivec3 core = glm::min(labels.dims() - corner, glm::ivec3(kSize));
  constexpr std::array<std::size_t, 3> kBack{1, kWide, std::size_t(kWide) * kWide};
  BrickSteps steps;
  for (int z = 0; z < core.z; ++z)
    for (int y = 0; y < core.y; ++y)
      for (int x = 0; x < core.x; ++x) {
        std::size_t at = (std::size_t(z + 1) * kWide + std::size_t(y + 1)) * kWide + std::size_t(x + 1);
        glm::ivec3 place(x, y, z);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          std::uint16_t before = ids[at - kBack[axis]];
          if ((before == 0) != (ids[at] == 0))
            steps[std::max(before, ids[at])][axis].set(std::size_t(place[int(axis)]));
        }
      }
  return steps;
}

std::map<std::uint16_t, Steps> findSteps(const LabelVolume& labels) {
  std::map<std::uint16_t, Steps> all;
  std::mutex guard;
  glm::ivec3 grid = labels.brickGrid();
  parallelFor(0, grid.x * grid.y * grid.z, [&](int i) {
    glm::ivec3 corner = glm::ivec3(i % grid.x, i / grid.x % grid.y, i / (grid.x * grid.y)) * kSize;
    BrickSteps found = stepsIn(labels, corner);
    std::lock_guard lock(guard);
    for (const auto& [id, axes] : found)
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t k = 0; k < kSize; ++k)
          if (axes[axis].test(k)) all[id][axis].push_back(corner[int(axis)] + int(k));
  });
  for (auto& [id, axes] : all)
    for (auto& planes : axes) {
      std::sort(planes.begin(), planes.end());
      planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
    }
  return all;
}

/// The size of blocks whose faces all lie on some planes; 1 where there is none.
double blockOf(const std::vector<int>& planes) {
  if (planes.size() < kFewestSteps) return 1.0;
  std::vector<int> gaps;
  for (std::size_t i = 1; i < planes.size(); ++i) gaps.push_back(planes[i] - planes[i - 1]);
  int least = *std::min_element(gaps.begin(), gaps.end());
  double sum = 0.0, count = 0.0;
  for (int gap : gaps)
    if (gap <= least + 1) sum += gap, ++count;
  double block = sum / count;
  for (int pass = 0; pass < 2; ++pass) {
    std::vector<double> blocks{0.0};  // from the first plane to each
    for (int gap : gaps) blocks.push_back(blocks.back() + std::max(std::round(gap / block), 1.0));
    // Each plane is the whole number next to the end of a block, so that two are off by less than one voxel together.
    double low = kLeastBlock, high = kLargestBlock;
    for (std::size_t i = 0; i < planes.size(); ++i)
      for (std::size_t j = i + 1; j < planes.size(); ++j) {
        low = std::max(low, (planes[j] - planes[i] - 1) / (blocks[j] - blocks[i]));
        high = std::min(high, (planes[j] - planes[i] + 1) / (blocks[j] - blocks[i]));
      }
    if (!(low <= high)) return 1.0;
    block = 0.5 * (low + high);
  }
  return block;
}

}  // namespace

LabelVolume smoothLabels(const LabelVolume& labels, std::span<const ShapeSmoothing> smoothings, Progress& progress) {
  for (const ShapeSmoothing& one : smoothings)
    if (!(one.deviation > 0.0)) throw ArgumentError(fmt::format("structure {} is smoothed by nothing", one.id));
  LabelVolume smooth = labels;
  if (smoothings.empty()) return smooth;
  BrickSmoothing work(labels, smoothings);
  glm::ivec3 grid = labels.brickGrid();
  std::mutex guard;
  std::atomic<int> done{0};
  int count = grid.x * grid.y * grid.z;
  parallelFor(0, count, [&](int i) {
    progress.throwIfCancelled();
    glm::ivec3 index(i % grid.x, i / grid.x % grid.y, i / (grid.x * grid.y));
    std::vector<std::uint16_t> ids = work.run(index);
    std::lock_guard lock(guard);
    if (!ids.empty()) smooth.write(index * kSize, glm::min(labels.dims() - index * kSize, glm::ivec3(kSize)), ids);
    progress.report(double(++done) / count, "Smoothing structures");
  });
  return smooth;
}

std::vector<BlockShape> findBlocks(const LabelVolume& labels) {
  std::vector<BlockShape> shapes;
  for (const auto& [id, steps] : findSteps(labels)) {
    BlockShape shape{id, glm::dvec3(blockOf(steps[0]), blockOf(steps[1]), blockOf(steps[2]))};
    if (int(shape.size.x > 1.0) + int(shape.size.y > 1.0) + int(shape.size.z > 1.0) >= 2) shapes.push_back(shape);
  }
  return shapes;
}

}  // namespace velum
