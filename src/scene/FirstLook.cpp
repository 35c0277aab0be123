#include "velum/scene/FirstLook.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "velum/scene/GreyWindows.h"
#include "velum/scene/Presets.h"

namespace velum::scene {

namespace {

constexpr double kMostOfFaces = 0.6;  ///< that may be opaque
constexpr int kFaceVoxels = 3;        ///< behind a place of a face, which make it opaque or not
constexpr int kLeastSide = 16;        ///< voxels; what has a shorter side is a slab

/// Values along short ways into the volume, from places all over the six faces of its box.
struct Borders {
  std::vector<double> values;  ///< kFaceVoxels for each way
};

Borders bordersOf(const Volume& volume) {
  Borders borders;
  glm::ivec3 last = volume.dims - 1;
  for (int axis = 0; axis < 3; ++axis) {
    int a = (axis + 1) % 3, b = (axis + 2) % 3;
    // Of a slab only the two large faces are looked at.
    if (volume.dims[a] < kLeastSide || volume.dims[b] < kLeastSide) continue;
    int stepA = std::max(1, volume.dims[a] / 60), stepB = std::max(1, volume.dims[b] / 60);
    for (int end = 0; end < 2; ++end)
      for (int i = stepA / 2; i < volume.dims[a]; i += stepA)
        for (int j = stepB / 2; j < volume.dims[b]; j += stepB)
          for (int k = 0; k < kFaceVoxels; ++k) {
            glm::ivec3 p;
            p[a] = i, p[b] = j;
            p[axis] = end == 0 ? std::min(k, last[axis]) : std::max(0, last[axis] - k);
            borders.values.push_back(valueAt(volume, p));
          }
  }
  return borders;
}

/// Share of the faces behind which most light is lost within three voxels.
double opaqueShare(const Borders& borders, const TransferFunction& transfer, double voxel) {
  if (borders.values.empty()) return 0.0;
  std::size_t opaque = 0;
  for (std::size_t i = 0; i < borders.values.size(); i += kFaceVoxels) {
    double clear = 1.0;
    for (std::size_t k = 0; k < kFaceVoxels; ++k)
      clear *= std::pow(1.0 - opacityAt(transfer.opacities, borders.values[i + k]), voxel / transfer.unitDistance);
    opaque += clear < 0.5;
  }
  return double(opaque * kFaceVoxels) / double(borders.values.size());
}

/// So that what lies on the faces is clear but for a share of it: the curve keeps its bright end, and its dark one
/// comes nearer.
void raiseFloor(TransferFunction& transfer, const Borders& borders, double shareLeft) {
  std::vector<double> values = borders.values;
  auto at = values.begin() + std::ptrdiff_t(double(values.size() - 1) * (1.0 - shareLeft));
  std::nth_element(values.begin(), at, values.end());
  double low = transfer.opacities.front().value, high = transfer.opacities.back().value;
  double floor = std::clamp(*at, low, low + 0.9 * (high - low));
  auto move = [&](double value) { return floor + (value - low) / (high - low) * (high - floor); };
  for (auto& point : transfer.opacities) point.value = move(point.value);
  for (auto& point : transfer.colors)
    if (point.value >= low && point.value <= high) point.value = move(point.value);
  std::sort(transfer.colors.begin(), transfer.colors.end(),
            [](const ColorPoint& a, const ColorPoint& b) { return a.value < b.value; });
}

/// Share of what lies on the faces that is not quite clear.
double veiledShare(const Borders& borders, const TransferFunction& transfer) {
  auto veiled = std::count_if(borders.values.begin(), borders.values.end(),
                              [&](double value) { return opacityAt(transfer.opacities, value) > 0.0; });
  return double(veiled) / double(std::max<std::size_t>(borders.values.size(), 1));
}

/// One axis is over twice as coarse as the others.
bool hasThickSlices(const Volume& volume) {
  glm::dvec3 s = spacingOf(volume);
  double finest = std::min(s.x, std::min(s.y, s.z)), coarsest = std::max(s.x, std::max(s.y, s.z));
  double middle = s.x + s.y + s.z - finest - coarsest;
  return coarsest > 2.0 * middle;
}

/// A single plane is shown as the picture that it is: nothing lies behind it, and light would only fall on its noise.
void showPlane(Scene& scene) {
  glm::dvec2 range = scene.volume.data->range;
  scene.volume.transfer.opacities = {{range.x, 0.99}, {range.y, 0.99}};
  scene.lighting.shaded = false;
}

}  // namespace

void applyFirstLook(Scene& scene) {
  const Volume& volume = *scene.volume.data;
  scene.volume.smooth = hasThickSlices(volume);
  std::string_view chosen = choosePreset(volume);
  applyPreset(scene, chosen);
  if (volume.isColor || volume.channels > 1) return;
  if (glm::dvec2 window = firstWindow(volume); window.y > 0) setWindow(scene.volume, window.x, window.y);
  int thickness = std::min(volume.dims.x, std::min(volume.dims.y, volume.dims.z));
  if (thickness == 1) return showPlane(scene);
  if (isAllMaterial(chosen) || isProjectionLook(chosen)) return;
  glm::dvec3 spacing = spacingOf(volume);
  double voxel = (spacing.x + spacing.y + spacing.z) / 3.0;
  Borders borders = bordersOf(volume);
  // Optical sections of a haze: what is bright in it. Of a slab the faces are cuts through the object.
  if (chosen == "microscopy" && thickness >= kLeastSide && veiledShare(borders, scene.volume.transfer) > 0.5)
    applyPreset(scene, "fluorescence");
  // What is there but for the most of what lies on the faces.
  for (double left : {0.2, 0.1, 0.05, 0.02})
    if (opaqueShare(borders, scene.volume.transfer, voxel) > kMostOfFaces)
      raiseFloor(scene.volume.transfer, borders, left);
}

}  // namespace velum::scene
