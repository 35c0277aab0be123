#include "io/meshes/ExtractSurface.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "core/Error.h"
#include "core/Parallel.h"
#include "io/Plugins.h"
#include "io/meshes/BorderWay.h"
#include "io/meshes/StructureShares.h"
#include "io/meshes/SurfaceShape.h"
#include "io/meshes/ThreeWayBorders.h"
#include "io/meshes/VoxelSurface.h"
#include "io/read/VtkQuiet.h"

namespace velum::io {

namespace {

/// How far smoothing may move a point, voxels, at a smoothness of 1: small and thin structures would shrivel without.
constexpr double kMostMoved = 1.4;

/// What the shape gains when a point moves: a third of the areas around it, along their normals.
std::vector<glm::dvec3> gains(const SurfaceShape& shape, double& volume) {
  std::vector<glm::dvec3> sums(shape.positions.size(), glm::dvec3(0.0));
  volume = 0.0;
  for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
    const std::uint32_t* corner = &shape.indices[i];
    glm::dvec3 a = shape.positions[corner[0]], b = shape.positions[corner[1]], c = shape.positions[corner[2]];
    glm::dvec3 third = glm::cross(b - a, c - a) / 6.0;
    volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    for (int k = 0; k < 3; ++k) sums[corner[k]] += third;
  }
  return sums;
}

glm::dvec3 unitOf(const glm::dvec3& v) {
  double length = glm::length(v);
  return length > 0 ? v / length : glm::dvec3(0, 0, 1);
}

std::vector<glm::dvec3> normalsOf(const SurfaceShape& shape) {
  double volume = 0.0;
  std::vector<glm::dvec3> normals = gains(shape, volume);
  for (glm::dvec3& normal : normals) normal = unitOf(normal);
  return normals;
}

/// The way between two voxels on whose middle a point lies.
BorderWay wayOf(const glm::dvec3& halfway) {
  glm::ivec3 from(glm::floor(halfway));
  glm::dvec3 rest = halfway - glm::dvec3(from);
  return {from, rest.x > 0 ? 0 : rest.y > 0 ? 1 : 2};
}

/// Points by the bricks of the labels in which their ways begin.
std::vector<std::vector<std::uint32_t>> pointsByBrick(const SurfaceShape& shape, glm::ivec3 brickGrid) {
  std::map<std::size_t, std::vector<std::uint32_t>> bricks;
  for (std::size_t i = 0; i < shape.positions.size(); ++i) {
    glm::ivec3 at = glm::max(wayOf(shape.positions[i]).from, glm::ivec3(0)) / LabelVolume::kBrickSize;
    std::size_t brick = (std::size_t(at.z) * std::size_t(brickGrid.y) + std::size_t(at.y)) * std::size_t(brickGrid.x);
    bricks[brick + std::size_t(at.x)].push_back(std::uint32_t(i));
  }
  std::vector<std::vector<std::uint32_t>> points;
  for (auto& [brick, own] : bricks) points.push_back(std::move(own));
  return points;
}

/// Moves some points from midway between voxels to the border, and gives them the normals that it has.
/// @param hasThird  is told of each whether a third structure is near
void moveToBorder(SurfaceShape& shape, const std::vector<std::uint32_t>& points, const StructureField& field,
                  std::uint16_t structure, std::vector<std::uint8_t>& hasThird) {
  glm::ivec3 low(std::numeric_limits<int>::max()), high(-1);
  for (std::uint32_t i : points) {
    glm::ivec3 from = wayOf(shape.positions[i]).from;
    low = glm::min(low, from), high = glm::max(high, from);
  }
  StructureShares shares(field, structure, low, high);
  for (std::uint32_t i : points) {
    BorderWay way = wayOf(shape.positions[i]);
    double part = shares.partOf(way);
    hasThird[i] = shares.hasThird(way) ? 1 : 0;
    glm::dvec3 normal = shares.normalAt(way, part);
    if (normal != glm::dvec3(0.0)) shape.normals[i] = normal;
    shape.positions[i] = way.at(part);
  }
}

/// @return of each point whether a third structure is near
std::vector<std::uint8_t> moveToBorder(SurfaceShape& shape, const StructureField& field, std::uint16_t structure,
                                       Progress& progress) {
  constexpr std::size_t kAtOnce = 32;  // bricks: some 20 ms on two cores
  shape.normals = normalsOf(shape);    // what borders without a slope keep
  std::vector<std::uint8_t> hasThird(shape.positions.size(), 0);
  auto points = pointsByBrick(shape, field.cover().labels()->brickGrid());
  for (std::size_t first = 0; first < points.size(); first += kAtOnce) {
    progress.report(double(first) / double(points.size()), "Borders");
    parallelFor(first, std::min(first + kAtOnce, points.size()),
                [&](std::size_t i) { moveToBorder(shape, points[i], field, structure, hasThird); });
  }
  return hasThird;
}

/// True of points between voxels that lie in one face of a cell: what joins them goes round the cell, not through it.
bool shareFace(const glm::dvec3& a, const glm::dvec3& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (a[axis] == b[axis] && a[axis] == std::floor(a[axis])) return true;
  return false;
}

bool isByValues(const StructureField& field, std::uint16_t structure) {
  const auto& borders = field.cover().borders();
  return std::any_of(borders.begin(), borders.end(), [&](const auto& border) { return border.structure == structure; });
}

/// How far a point is moved outwards, of how far it lies before the middle of those next to it, so that balls of 4 to
/// 25 voxels enclose what they do: values tell where points are; LabelCover has made up for most of it elsewhere.
constexpr double kRoundByValues = 0.5, kRoundByLabels = 0.15;

/// Moves points outwards by what triangles cut off from what is round. The four points next to one in the faces of
/// cells, and so whichever way cells are divided, tell how round it is.
/// @param halfway  the points before they moved to the border
void roundOut(SurfaceShape& shape, const std::vector<glm::dvec3>& halfway, double part) {
  constexpr double kMost = 0.05;  // voxels: a ball of three wants it; corners stay corners
  std::vector<glm::dvec3> sums(halfway.size(), glm::dvec3(0.0));
  std::vector<std::uint8_t> counts(halfway.size(), 0);
  for (std::size_t i = 0; i < shape.indices.size(); ++i) {
    std::size_t a = shape.indices[i], b = shape.indices[i % 3 == 2 ? i - 2 : i + 1];
    if (!shareFace(halfway[a], halfway[b])) continue;
    sums[a] += shape.positions[b] - shape.positions[a];
    ++counts[a];
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (counts[i] == 0) continue;
    double before = -glm::dot(sums[i], shape.normals[i]) / counts[i];
    shape.positions[i] += std::clamp(part * before, -kMost, kMost) * shape.normals[i];
  }
}

/// Moves the points along their normals until the shape encloses a volume. @param most  how far at most, voxels
void keepVolume(SurfaceShape& shape, double wanted, double most) {
  constexpr int kSteps = 6;
  constexpr double kExact = 1e-6;  // of the volume
  double moved = 0.0;
  for (int step = 0; step < kSteps; ++step) {
    double volume = 0.0, slope = 0.0;
    auto sums = gains(shape, volume);
    for (const glm::dvec3& sum : sums) slope += glm::length(sum);
    if (std::abs(volume - wanted) < kExact * wanted || !(slope > 0)) return;
    double by = std::clamp((wanted - volume) / slope, -most - moved, most - moved);
    for (std::size_t i = 0; i < sums.size(); ++i) shape.positions[i] += by * unitOf(sums[i]);
    moved += by;
  }
}

vtkSmartPointer<vtkPolyData> trianglesOf(const SurfaceShape& shape) {
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(vtkIdType(shape.positions.size()));
  for (std::size_t i = 0; i < shape.positions.size(); ++i) points->SetPoint(vtkIdType(i), &shape.positions[i].x);
  vtkNew<vtkCellArray> cells;
  for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
    vtkIdType corners[] = {shape.indices[i], shape.indices[i + 1], shape.indices[i + 2]};
    cells->InsertNextCell(3, corners);
  }
  auto triangles = vtkSmartPointer<vtkPolyData>::New();
  triangles->SetPoints(points);
  triangles->SetPolys(cells);
  return triangles;
}

/// Rounds the shape off, but moves no point by more than is said above, and keeps the volume that it had.
void smoothShape(SurfaceShape& shape, double smoothness, Progress& progress) {
  VtkQuiet quiet;
  vtkNew<vtkWindowedSincPolyDataFilter> smooth;
  quiet.listen(*smooth, &progress);
  smooth->SetInputData(trianglesOf(shape));
  // The range that 3D Slicer's slider has, so that the same number means the same there.
  smooth->SetNumberOfIterations(20 + int(std::lround(40.0 * smoothness)));
  smooth->SetPassBand(std::pow(10.0, -4.0 * smoothness));
  smooth->BoundarySmoothingOff();
  smooth->FeatureEdgeSmoothingOff();
  smooth->NonManifoldSmoothingOn();
  smooth->NormalizeCoordinatesOn();
  smooth->Update();
  progress.throwIfCancelled();
  double wanted = 0.0, most = kMostMoved * smoothness;
  gains(shape, wanted);
  for (std::size_t i = 0; i < shape.positions.size(); ++i) {
    glm::dvec3 to, &from = shape.positions[i];
    smooth->GetOutput()->GetPoint(vtkIdType(i), &to.x);
    double length = glm::length(to - from);
    from = length > most ? from + (to - from) * (most / length) : to;
  }
  keepVolume(shape, wanted, most);
  shape.normals = normalsOf(shape);
}

Mesh meshOf(const SurfaceShape& shape, const glm::dmat4& worldFromVoxel) {
  Mesh mesh;
  mesh.positions.reserve(shape.positions.size());
  mesh.normals.reserve(shape.normals.size());
  glm::dmat3 axes(worldFromVoxel), turn = glm::transpose(glm::inverse(axes));
  for (const glm::dvec3& p : shape.positions) mesh.positions.emplace_back(worldFromVoxel * glm::dvec4(p, 1.0));
  for (const glm::dvec3& n : shape.normals) mesh.normals.emplace_back(glm::normalize(turn * n));
  mesh.indices = shape.indices;
  if (glm::determinant(axes) < 0)
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  return mesh;
}

}  // namespace

Mesh plugin::extractSurface(const StructureField& field, std::uint16_t structure, glm::ivec3 low, glm::ivec3 high,
                            double smoothness, Progress& progress) {
  const LabelVolume& labels = *field.cover().labels();
  // Which voxels are the structure's says what is joined to what, so that the surface is closed whatever lies between.
  SurfaceShape shape = voxelSurface(labels, structure, low, high, progress);
  std::vector<glm::dvec3> halfway = shape.positions;
  auto hasThird = moveToBorder(shape, field, structure, progress);
  roundOut(shape, halfway, isByValues(field, structure) ? kRoundByValues : kRoundByLabels);
  joinWhereThreeMeet(shape, {halfway, hasThird}, field);
  if (smoothness > 0.0) smoothShape(shape, std::min(smoothness, 1.0), progress);
  return meshOf(shape, labels.worldFromVoxel());
}

}  // namespace velum::io
