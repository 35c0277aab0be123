#include "session/membrane/TissueInNoise.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "membrane/forces/Denoise.h"
#include "scene/Scene.h"
#include "scene/Shown.h"

namespace velum::session {

namespace {

/// A threshold halfway between two materials that differ by less than so many standard deviations of the noise gets
/// more than one voxel in a thousand wrong: too many, where one of them is a hundredth of the other.
constexpr double kNoisy = 6.0;
constexpr int kAround = 24;              ///< voxels around a click that are looked at
constexpr int kBlock = 24, kBlocks = 4;  ///< the data is known by blocks of so many voxels, so many along each axis
constexpr double kEnd = 0.1;             ///< share of the data beyond which there is nothing else worth telling apart

/// The voxels of a box, its noise taken out.
scene::VolumeLayer calmBox(const scene::VolumeLayer& layer, glm::ivec3 first, glm::ivec3 end, double noise) {
  const Volume& volume = *layer.data;
  int channel = scene::shownChannel(layer), timeStep = scene::shownTimeStep(layer);
  Volume box;
  box.dims = end - first;
  box.type = SampleType::Float32;
  box.range = volume.range;
  box.worldFromVoxel = glm::translate(volume.worldFromVoxel, glm::dvec3(first));
  box.voxels.resize(voxelCount(box) * sizeof(float));
  auto* out = reinterpret_cast<float*>(box.voxels.data());
  for (glm::ivec3 p = first; p.z < end.z; ++p.z)
    for (p.y = first.y; p.y < end.y; ++p.y)
      for (p.x = first.x; p.x < end.x; ++p.x) *out++ = float(valueAt(volume, p, channel, timeStep));
  scene::VolumeLayer calm = layer;
  calm.data = Shared<Volume>(membrane::denoise(box, 0, 0, noise, Progress()));
  calm.channel = calm.timeStep = 0;
  return calm;
}

/// Values all over the data, and how steep it is there, by the voxel.
struct Steepness {
  float value, perVoxel;
};

void addBlock(const scene::VolumeLayer& layer, glm::ivec3 first, double noise, std::vector<Steepness>& out) {
  glm::ivec3 end = glm::min(first + kBlock, layer.data->dims);
  const scene::VolumeLayer calm = calmBox(layer, first, end, noise);
  const Volume& volume = *calm.data;
  for (glm::ivec3 p(1); p.z + 1 < volume.dims.z; ++p.z)
    for (p.y = 1; p.y + 1 < volume.dims.y; ++p.y)
      for (p.x = 1; p.x + 1 < volume.dims.x; ++p.x) {
        glm::dvec3 slope(0.0);
        for (int axis = 0; axis < 3; ++axis) {
          glm::ivec3 step(0);
          step[axis] = 1;
          slope[axis] = 0.5 * (valueAt(volume, p + step) - valueAt(volume, p - step));
        }
        double value = valueAt(volume, p), steep = glm::length(slope);
        if (std::isfinite(value + steep)) out.push_back({float(value), float(steep)});
      }
}

std::vector<Steepness> lookAround(const scene::VolumeLayer& layer, double noise) {
  std::vector<Steepness> all;
  glm::ivec3 dims = layer.data->dims, blocks = glm::min((dims + kBlock - 1) / kBlock, glm::ivec3(kBlocks));
  auto placeOf = [&](int i, int axis) {  // the first at the start, the last at the end
    return blocks[axis] < 2 ? 0 : std::max(0, dims[axis] - kBlock) * i / (blocks[axis] - 1);
  };
  for (int z = 0; z < blocks.z; ++z)
    for (int y = 0; y < blocks.y; ++y)
      for (int x = 0; x < blocks.x; ++x) addBlock(layer, {placeOf(x, 0), placeOf(y, 1), placeOf(z, 2)}, noise, all);
  return all;
}

float valueAtShare(std::vector<Steepness>& all, double share) {
  auto at = all.begin() + std::ptrdiff_t(share * double(all.size() - 1));
  std::nth_element(all.begin(), at, all.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
  return at->value;
}

/// The value, on the way from one to another, from which on the data hardly gets steeper: where the steepest flanks of
/// what lies at the end of that way begin.
std::optional<double> steepFrom(const std::vector<Steepness>& all, double from, double to, double noise) {
  constexpr double kBinsAcross = 16.0;  // of a standard deviation of the noise
  constexpr std::size_t kApart = 4;
  constexpr double kHardly = 1.035;  // by what is seen of steepness: means of a thousand voxels vary by a hundredth
  constexpr double kEnough = 40.0;   // voxels that a mean takes
  double sign = to < from ? -1.0 : 1.0, width = noise / kBinsAcross;
  auto bins = std::size_t(std::min(std::abs(to - from) / width, 4096.0));
  std::vector<double> sums(bins, 0.0), counts(bins, 0.0), steep;
  for (const auto& one : all) {
    double place = sign * (one.value - from) / width;
    if (place < 0 || place >= double(bins)) continue;
    sums[std::size_t(place)] += one.perVoxel;
    ++counts[std::size_t(place)];
  }
  for (std::size_t i = 1; i + 1 < bins; ++i) {
    double count = counts[i - 1] + 2.0 * counts[i] + counts[i + 1];
    if (count < 4.0 * kEnough) break;
    steep.push_back((sums[i - 1] + 2.0 * sums[i] + sums[i + 1]) / count);
  }
  // Steepness grows first slowly among what is beside: on from where it has grown to half of its most.
  if (steep.empty()) return std::nullopt;
  double half = 0.5 * (steep.front() + *std::max_element(steep.begin(), steep.end()));
  for (std::size_t i = 0; i + kApart < steep.size(); ++i)
    if (steep[i] > half && steep[i + kApart] < kHardly * steep[i]) return from + sign * width * (double(i) + 1.5);
  return std::nullopt;
}

}  // namespace

std::optional<Tissue> measureTissueInNoise(const scene::VolumeLayer& layer, glm::dvec3 world) {
  if (!layer.data || layer.data->isColor) return std::nullopt;
  const Volume& volume = *layer.data;
  glm::dvec3 place(glm::inverse(volume.worldFromVoxel) * glm::dvec4(world, 1.0));
  glm::ivec3 voxel(glm::floor(place + 0.5));
  if (glm::any(glm::lessThan(voxel, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(voxel, volume.dims)))
    return std::nullopt;
  double noise = membrane::noiseOf(volume, scene::shownChannel(layer), scene::shownTimeStep(layer));
  if (!(noise > 0.0)) return std::nullopt;
  glm::ivec3 first = glm::max(voxel - kAround, glm::ivec3(0)), end = glm::min(voxel + kAround + 1, volume.dims);
  auto tissue = measureTissue(calmBox(layer, first, end, noise), world);
  if (!tissue) return tissue;
  // Borders lie halfway to what is beside.
  double toBorder =
      std::min(tissue->value - tissue->low.value_or(-1e300), tissue->high.value_or(1e300) - tissue->value);
  if (2.0 * toBorder > kNoisy * noise) return std::nullopt;
  std::vector<Steepness> all = lookAround(layer, noise);
  if (all.empty()) return tissue;
  double middle = valueAtShare(all, 0.5);
  if (tissue->value > valueAtShare(all, 1.0 - kEnd)) {
    if (auto low = steepFrom(all, middle, valueAtShare(all, 0.9999), noise))
      tissue->low = std::min(*low, tissue->value);
  } else if (tissue->value < valueAtShare(all, kEnd)) {
    if (auto high = steepFrom(all, middle, valueAtShare(all, 0.0001), noise))
      tissue->high = std::max(*high, tissue->value);
  }
  return tissue;
}

}  // namespace velum::session
