#include "scene/FirstLook.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/AnatomyColors.h"
#include "scene/GreyWindows.h"
#include "scene/Presets.h"

namespace velum::scene {

namespace {

constexpr double kMostOfFaces = 0.6;  ///< that may be opaque
constexpr int kFaceVoxels = 3;        ///< behind a place of a face, which make it opaque or not
constexpr int kLeastSide = 16;        ///< voxels; what has a shorter side is a slab
constexpr int kSolidCells = 64;       ///< along the longest side, in which it is asked whether something is solid
constexpr double kThin = 0.05;        ///< of the mean side, that cells and fibres are hardly thicker than to both sides
constexpr double kSeen = 0.1;         ///< opacity of what is about a tenth as bright as what is brightest
constexpr float kMostAbout = 0.8f;    ///< of the cells about one of something solid, that are seen
constexpr double kSolid = 0.5;        ///< of what is seen, that is within something solid in tissue

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

/// A coarse grid over a volume. [z][y][x]
struct Cells {
  glm::ivec3 step, dims;  ///< step: voxels along a cell's edges
  std::vector<float> values;
  float& at(glm::ivec3 cell) {
    return values[(std::size_t(cell.z) * std::size_t(dims.y) + std::size_t(cell.y)) * std::size_t(dims.x) +
                  std::size_t(cell.x)];
  }
  template <class Visit>
  void forAll(const Visit& visit) {
    glm::ivec3 cell;
    for (cell.z = 0; cell.z < dims.z; ++cell.z)
      for (cell.y = 0; cell.y < dims.y; ++cell.y)
        for (cell.x = 0; cell.x < dims.x; ++cell.x) visit(cell);
  }
};

/// 1 where something is seen, by the mean of a few voxels: noise would be holes.
Cells seenCells(const Volume& volume, const TransferFunction& transfer) {
  int longest = std::max(volume.dims.x, std::max(volume.dims.y, volume.dims.z));
  Cells cells;
  cells.step = glm::max(glm::ivec3(1), glm::min(glm::ivec3((longest + kSolidCells - 1) / kSolidCells), volume.dims));
  cells.dims = volume.dims / cells.step;
  cells.values.resize(std::size_t(cells.dims.x) * std::size_t(cells.dims.y) * std::size_t(cells.dims.z));
  cells.forAll([&](glm::ivec3 cell) {
    glm::ivec3 middle = cell * cells.step + cells.step / 2;
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner)
      sum += valueAt(volume, glm::min(middle + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2), volume.dims - 1));
    cells.at(cell) = opacityAt(transfer.opacities, sum / 8.0) > kSeen ? 1.0f : 0.0f;
  });
  return cells;
}

/// Means along an axis, over so many cells to both sides.
void smear(Cells& cells, int axis, int reach) {
  Cells before = cells;
  cells.forAll([&](glm::ivec3 cell) {
    float sum = 0;
    for (int d = -reach; d <= reach; ++d) {
      glm::ivec3 beside = cell;
      beside[axis] = std::clamp(cell[axis] + d, 0, cells.dims[axis] - 1);
      sum += before.at(beside);
    }
    cells.at(cell) = sum / float(2 * reach + 1);
  });
}

/// How much of what is seen lies within something solid, where most of what is about it is seen, too: most of tissue,
/// less of cells, next to nothing of fibres.
double solidShare(const Volume& volume, const TransferFunction& transfer) {
  Cells seen = seenCells(volume, transfer), about = seen;
  int reach = std::max(1, int(std::lround(kThin * std::cbrt(double(seen.values.size())))));
  for (int axis = 0; axis < 3; ++axis)
    if (volume.dims[axis] >= kLeastSide) smear(about, axis, reach);  // a slab is a cut through it
  double all = 0, solid = 0;
  for (std::size_t i = 0; i < seen.values.size(); ++i) {
    all += seen.values[i];
    solid += seen.values[i] > 0 && about.values[i] > kMostAbout;
  }
  return all > 0 ? solid / all : 0.0;
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
  if (auto window = fileWindow(volume, 0))
    setWindow(scene.volume, (window->x + window->y) / 2.0, window->y - window->x);
  int thickness = std::min(volume.dims.x, std::min(volume.dims.y, volume.dims.z));
  if (thickness == 1) return showPlane(scene);
  if (isAllMaterial(chosen) || isProjectionLook(chosen)) return;
  glm::dvec3 spacing = spacingOf(volume);
  double voxel = (spacing.x + spacing.y + spacing.z) / 3.0;
  Borders borders = bordersOf(volume);
  // Optical sections of a haze: what is bright in it. Of a slab the faces are cuts through the object. And of cells and
  // fibres on dark ground, which the look of tissue makes mud of.
  bool isHaze = thickness >= kLeastSide && veiledShare(borders, scene.volume.transfer) > 0.5;
  if (chosen == "microscopy" && (isHaze || solidShare(volume, scene.volume.transfer) < kSolid))
    applyPreset(scene, "fluorescence");
  // What is there but for the most of what lies on the faces.
  for (double left : {0.2, 0.1, 0.05, 0.02})
    if (opaqueShare(borders, scene.volume.transfer, voxel) > kMostOfFaces)
      raiseFloor(scene.volume.transfer, borders, left);
}

namespace {
/// How far a structure that is made of blocks is smoothed, so that they are not seen: by as much as they are large.
double smoothingOf(const LabelVolume& labels, const BlockShape& shape) {
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
    if (shape.size[axis] > 1.0)
      largest = std::max(largest, shape.size[axis] * glm::length(glm::dvec3(labels.worldFromVoxel()[axis])));
  return largest;
}
}  // namespace

void applyFirstLook(LabelLayer& labels) {
  if (labels.data)
    for (const BlockShape& shape : findBlocks(*labels.data))
      for (auto& structure : labels.structures)
        if (structure.id == shape.id) structure.smoothing = smoothingOf(*labels.data, shape);
  // What writes names into NIfTI files has colours made by number; other formats hold those that somebody chose.
  bool hasOwn = labels.source.path.find(".nii") == std::string::npos;
  for (auto& structure : labels.structures) {
    auto id = std::uint16_t(structure.id);
    // A scan shows its own skin, smoother than voxels have it, and as a surface it would hide all else.
    structure.showAs = isSkin(structure.name) ? ShowAs::Material : ShowAs::Solid;
    if (structure.color == defaultLabelColor(id) || (!hasOwn && anatomyColor(structure.name)))
      structure.color = solidColor(id, structure.name);
  }
}

}  // namespace velum::scene
