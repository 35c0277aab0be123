#include <fmt/format.h>
#include <gdcmReader.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>

#include "core/Parallel.h"
#include "core/SayCount.h"
#include "io/Plugins.h"
#include "io/labels/LabelTables.h"
#include "io/read/Refuse.h"
#include "io/volumes/DicomFile.h"
#include "io/volumes/DicomSoundness.h"
#include "io/volumes/DicomTags.h"
#include "io/volumes/Readers.h"

namespace velum::io {

namespace {

using gdcm::DataSet;
using gdcm::Tag;

constexpr double kSamePlane = 0.01;                          ///< mm
constexpr double kParallel = 0.999;                          ///< Cosine between normals that are one.
constexpr double kPixel = 0.5;                               ///< mm, where the contours are of a patient's size
constexpr double kMostPixels = 768.0, kLeastPixels = 128.0;  ///< Along the longer side.
constexpr double kMostPlanes = 65535.0;

/// A closed line in one plane, mm, LPS.
struct Contour {
  std::vector<glm::dvec3> points;
  double height = 0.0;  ///< Of its plane along the normal.
};

/// A region of interest.
struct Region {
  LabelInfo label;
  std::optional<glm::vec3> color;  ///< Where the file has one.
  std::vector<Contour> contours;
  double gap = 0.0;   ///< Between planes that have contours of it.
  double area = 0.0;  ///< Of all contours: large regions lie under small ones.
};

/// Its length is twice the area (Newell).
glm::dvec3 areaOf(const std::vector<glm::dvec3>& points) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < points.size(); ++i) sum += glm::cross(points[i], points[(i + 1) % points.size()]);
  return sum;
}

std::vector<glm::dvec3> pointsOf(const DataSet& item) {
  std::vector<double> numbers = numbersOf(item, Tag(0x3006, 0x0050));
  std::vector<glm::dvec3> points;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  bool isSound = std::all_of(points.begin(), points.end(),
                             [](glm::dvec3 p) { return std::isfinite(p.x + p.y + p.z) && glm::length(p) < 1e6; });
  return isSound ? points : std::vector<glm::dvec3>();
}

/// Names by number.
std::map<int, std::string> namesOf(const DataSet& set) {
  std::map<int, std::string> names;
  auto items = sequenceOf(set, Tag(0x3006, 0x0020));
  for (std::size_t i = 1; items && i <= items->GetNumberOfItems(); ++i) {
    const DataSet& item = items->GetItem(i).GetNestedDataSet();
    names[int(numberOf(item, Tag(0x3006, 0x0022), 0))] = textOf(item, Tag(0x3006, 0x0026));
  }
  return names;
}

/// Contours that are no closed lines in a plane are counted, not read.
std::vector<Contour> contoursOf(const DataSet& region, std::size_t& others) {
  std::vector<Contour> contours;
  auto items = sequenceOf(region, Tag(0x3006, 0x0040));
  for (std::size_t i = 1; items && i <= items->GetNumberOfItems(); ++i) {
    const DataSet& item = items->GetItem(i).GetNestedDataSet();
    std::string type = textOf(item, Tag(0x3006, 0x0042));
    Contour contour{pointsOf(item), 0.0};
    bool isClosed = type == "CLOSED_PLANAR" || type == "CLOSEDPLANAR_XOR" || type.empty();
    if (isClosed && contour.points.size() >= 3 && glm::length(areaOf(contour.points)) > 0.0)
      contours.push_back(std::move(contour));
    else
      ++others;
  }
  return contours;
}

/// Numbers of regions may be any: also 0, which stands for nothing here.
std::vector<Region> regionsOf(const DataSet& set, std::size_t& others) {
  std::vector<Region> regions;
  std::vector<int> numbers;
  auto names = namesOf(set);
  auto items = sequenceOf(set, Tag(0x3006, 0x0039));
  for (std::size_t i = 1; items && i <= items->GetNumberOfItems(); ++i) {
    const DataSet& item = items->GetItem(i).GetNestedDataSet();
    Region region;
    int number = int(numberOf(item, Tag(0x3006, 0x0084), double(i)));
    numbers.push_back(number);
    region.label.name = names.count(number) ? names[number] : std::string();
    if (auto color = numbersOf(item, Tag(0x3006, 0x002a)); color.size() == 3)
      region.color = glm::clamp(glm::vec3(color[0], color[1], color[2]) / 255.0f, 0.0f, 1.0f);
    region.contours = contoursOf(item, others);
    regions.push_back(std::move(region));
  }
  std::vector<std::uint16_t> ids = idsApart(numbers);
  for (std::size_t i = 0; i < regions.size(); ++i) {
    regions[i].label.id = ids[i];
    regions[i].label.color = regions[i].color.value_or(defaultLabelColor(ids[i]));
  }
  return regions;
}

/// The grid into which contours are filled: along their planes.
struct ContourGrid {
  glm::dvec3 right{1, 0, 0}, down{0, 1, 0}, normal{0, 0, 1};
  glm::dvec3 low{0.0}, high{0.0};  ///< Along these axes, mm.
  double pixel = 1.0, step = 1.0;
  glm::ivec3 dims{1};

  glm::dvec3 along(glm::dvec3 p) const { return {glm::dot(p, right), glm::dot(p, down), glm::dot(p, normal)}; }
  glm::dmat4 worldFromVoxel() const {
    glm::dvec3 first = right * low.x + down * low.y + normal * low.z;
    return {glm::dvec4(right * pixel, 0), glm::dvec4(down * pixel, 0), glm::dvec4(normal * step, 0),
            glm::dvec4(first, 1)};
  }
};

/// The patient's axes where the contours lie across one.
void layAxes(ContourGrid& grid, glm::dvec3 normal) {
  int main = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (std::abs(normal[axis]) > std::abs(normal[main])) main = axis;
  grid.normal = normal[main] < 0 ? -normal : normal;
  glm::dvec3 aside(0.0);
  aside[main == 0 ? 1 : 0] = 1.0;
  grid.right = glm::normalize(aside - grid.normal * glm::dot(aside, grid.normal));
  grid.down = glm::cross(grid.normal, grid.right);
}

/// The smallest gap that is not rounding; 0 where all lie in one plane.
double gapOf(std::vector<double> heights) {
  std::sort(heights.begin(), heights.end());
  double least = 0.0;
  for (std::size_t i = 1; i < heights.size(); ++i)
    if (double gap = heights[i] - heights[i - 1]; gap > kSamePlane && (least == 0.0 || gap < least)) least = gap;
  return least;
}

/// Drops contours across the others and says how many. Sets heights, gaps and areas of regions.
ContourGrid layGrid(std::vector<Region>& regions, const Path& path, std::size_t& across) {
  ContourGrid grid;
  glm::dvec3 largest(0.0);
  for (const Region& region : regions)
    for (const Contour& contour : region.contours)
      if (glm::dvec3 area = areaOf(contour.points); glm::length(area) > glm::length(largest)) largest = area;
  if (glm::length(largest) == 0.0) refuse(path, "the structure set has no closed contours");
  layAxes(grid, glm::normalize(largest));
  grid.low = glm::dvec3(1e30);
  grid.high = glm::dvec3(-1e30);
  std::vector<double> heights;
  for (Region& region : regions) {
    across += std::erase_if(region.contours, [&](const Contour& contour) {
      return std::abs(glm::dot(glm::normalize(areaOf(contour.points)), grid.normal)) < kParallel;
    });
    std::vector<double> own;
    for (Contour& contour : region.contours) {
      contour.height = grid.along(contour.points[0]).z;
      own.push_back(contour.height);
      region.area += 0.5 * glm::length(areaOf(contour.points));
      for (glm::dvec3 point : contour.points) {
        grid.low = glm::min(grid.low, grid.along(point));
        grid.high = glm::max(grid.high, grid.along(point));
      }
    }
    region.gap = gapOf(own);
    heights.insert(heights.end(), own.begin(), own.end());
  }
  grid.step = gapOf(heights);
  if (grid.step == 0.0) grid.step = 1.0;
  double longer = std::max(grid.high.x - grid.low.x, grid.high.y - grid.low.y);
  grid.pixel = std::clamp(kPixel, longer / kMostPixels, longer / kLeastPixels);
  glm::dvec3 extent = grid.high - grid.low;
  if (extent.z / grid.step > kMostPlanes) refuse(path, "its contours do not fit on a grid");
  grid.low -= glm::dvec3(grid.pixel, grid.pixel, 0.0);  // a margin, so that nothing is cut
  grid.dims = {int(extent.x / grid.pixel) + 3, int(extent.y / grid.pixel) + 3,
               int(std::lround(extent.z / grid.step)) + 1};
  return grid;
}

/// Where a region is inside in one plane: between its contours' crossings with each row, the first to the second, the
/// third to the fourth, so that a contour in another one is a hole.
void fillPlane(const ContourGrid& grid, const std::vector<const Contour*>& contours, std::uint16_t id,
               std::uint16_t* ids, std::uint64_t& overlaps) {
  for (int y = 0; y < grid.dims.y; ++y) {
    double row = grid.low.y + y * grid.pixel;
    std::vector<double> crossings;
    for (const Contour* contour : contours)
      for (std::size_t i = 0; i < contour->points.size(); ++i) {
        glm::dvec3 a = grid.along(contour->points[i]),
                   b = grid.along(contour->points[(i + 1) % contour->points.size()]);
        if ((a.y <= row) == (b.y <= row)) continue;
        crossings.push_back(a.x + (b.x - a.x) * (row - a.y) / (b.y - a.y));
      }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      int from = std::max(0, int(std::ceil((crossings[i] - grid.low.x) / grid.pixel)));
      int to = std::min(grid.dims.x - 1, int(std::floor((crossings[i + 1] - grid.low.x) / grid.pixel)));
      for (int x = from; x <= to; ++x) {
        std::uint16_t& here = ids[std::size_t(y) * std::size_t(grid.dims.x) + std::size_t(x)];
        overlaps += here != 0 && here != id;
        here = id;
      }
    }
  }
}

/// The contours that a plane of the grid takes: its own, or where a region has them in every second plane only, the
/// nearest.
std::vector<const Contour*> contoursAt(const Region& region, double height, double step) {
  double reach = 0.5 * std::max(region.gap, step) + kSamePlane, nearest = reach;
  std::optional<double> found;
  for (const Contour& contour : region.contours)
    if (double off = std::abs(contour.height - height); off < nearest) {
      nearest = off;
      found = contour.height;
    }
  std::vector<const Contour*> contours;
  for (const Contour& contour : region.contours)
    if (found && std::abs(contour.height - *found) <= kSamePlane) contours.push_back(&contour);
  return contours;
}

std::uint64_t fill(LabelVolume& labels, const ContourGrid& grid, const std::vector<Region>& regions,
                   Progress& progress) {
  std::size_t plane = std::size_t(grid.dims.x) * std::size_t(grid.dims.y);
  std::vector<std::uint16_t> slab;
  std::uint64_t overlaps = 0;
  for (int z = 0; z < grid.dims.z; z += LabelVolume::kBrickSize) {
    int depth = std::min(LabelVolume::kBrickSize, grid.dims.z - z);
    slab.assign(plane * std::size_t(depth), 0);
    std::vector<std::uint64_t> counts(std::size_t(depth), 0);
    parallelFor(0, depth, [&](int k) {
      double height = grid.low.z + (z + k) * grid.step;
      for (const Region& region : regions)
        fillPlane(grid, contoursAt(region, height, grid.step), region.label.id, slab.data() + plane * std::size_t(k),
                  counts[std::size_t(k)]);
    });
    for (std::uint64_t count : counts) overlaps += count;
    labels.write({0, 0, z}, {grid.dims.x, grid.dims.y, depth}, slab);
    progress.report(double(z + depth) / grid.dims.z, "Filling contours");
  }
  return overlaps;
}

}  // namespace

LabelVolume plugin::readRtStruct(const scene::Source& source, Progress& progress) {
  Path path = source.path;
  auto file = readDicomHeader(path);
  if (!file) refuse(path, "is damaged, or no DICOM structure set");
  std::ifstream stream(path, std::ios::binary);
  gdcm::Reader reader;
  reader.SetStream(stream);
  bool isRead = false;
  try {
    isRead = reader.Read();
  } catch (const std::exception&) {
    // GDCM throws on damage.
  }
  if (!isRead) refuse(path, "the DICOM structure set is damaged");
  std::size_t others = 0, across = 0;
  auto regions = regionsOf(reader.GetFile().GetDataSet(), others);
  ContourGrid grid = layGrid(regions, path, across);
  // Small ones lie over large ones: the outline of the body has all others in it.
  std::stable_sort(regions.begin(), regions.end(), [](const Region& a, const Region& b) { return a.area > b.area; });
  LabelVolume labels(grid.dims, grid.worldFromVoxel());
  std::uint64_t overlaps = fill(labels, grid, regions, progress);
  std::vector<LabelInfo> table;
  for (const Region& region : regions) table.push_back(region.label);
  labels.name = file->description.empty() ? path.stem().string() : file->description;
  labels.table = completeTable(std::move(table), labels.idsInUse());
  if (others > 0)
    labels.warnings.push_back(sayCount(others, "1 point or open line of the structure set is left out",
                                       "{} points and open lines of the structure set are left out"));
  if (across > 0)
    labels.warnings.push_back(sayCount(across, "1 contour lies across the others and is left out",
                                       "{} contours lie across the others and are left out"));
  if (overlaps > 0)
    labels.warnings.push_back(sayCount(overlaps, "1 voxel belongs to several structures; the smaller one has it",
                                       "{} voxels belong to several structures; the smaller one has them"));
  return labels;
}

}  // namespace velum::io
