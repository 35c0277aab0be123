#include "velum/io/meshes/ExtractSurface.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkDiscreteFlyingEdges3D.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "read/VtkQuiet.h"
#include "velum/core/Error.h"

namespace velum::io {

namespace {

/// How far smoothing may move a point, voxels, at a smoothness of 1: steps are half a voxel high, and what goes further
/// is form. Small and thin structures would shrivel without.
constexpr double kMostMoved = 1.4;

/// In the world, in doubles: far from the origin floats would have steps of their own.
struct Shape {
  std::vector<glm::dvec3> positions;
  std::vector<std::uint32_t> indices;
};

/// 1 in the structure, with a border of 0 all around.
vtkSmartPointer<vtkImageData> maskOf(const LabelVolume& labels, std::uint16_t structure, glm::ivec3 low,
                                     glm::ivec3 size, std::uint64_t& voxels) {
  glm::ivec3 padded = size + 2;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(padded.x, padded.y, padded.z);
  image->SetOrigin(low.x - 1, low.y - 1, low.z - 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* to = static_cast<unsigned char*>(image->GetScalarPointer());
  std::fill(to, to + std::size_t(image->GetNumberOfPoints()), static_cast<unsigned char>(0));
  std::vector<std::uint16_t> plane(std::size_t(size.x) * std::size_t(size.y));
  for (int z = 0; z < size.z; ++z) {
    labels.read({low.x, low.y, low.z + z}, {size.x, size.y, 1}, plane);
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        if (plane[std::size_t(y) * std::size_t(size.x) + std::size_t(x)] != structure) continue;
        ++voxels;
        to[(std::size_t(z + 1) * std::size_t(padded.y) + std::size_t(y + 1)) * std::size_t(padded.x) +
           std::size_t(x + 1)] = 1;
      }
  }
  return image;
}

/// Takes points back that have moved further than `most`.
void keepNear(vtkPoints& from, vtkPoints& to, double most) {
  for (vtkIdType i = 0; i < to.GetNumberOfPoints(); ++i) {
    glm::dvec3 a, b;
    from.GetPoint(i, &a.x);
    to.GetPoint(i, &b.x);
    double length = glm::length(b - a);
    if (!(length > most)) continue;
    b = a + (b - a) * (most / length);
    to.SetPoint(i, &b.x);
  }
}

/// In voxel space. The smoothing is linear, so that it does not matter in which space it is done.
vtkSmartPointer<vtkPolyData> surfaceOf(vtkImageData* mask, double smoothness, Progress& progress) {
  VtkQuiet quiet;
  vtkNew<vtkDiscreteFlyingEdges3D> edges;
  quiet.listen(*edges, &progress);
  edges->SetInputData(mask);
  edges->SetNumberOfContours(1);
  edges->SetValue(0, 1);
  edges->ComputeNormalsOff();
  edges->ComputeGradientsOff();
  edges->ComputeScalarsOff();
  edges->Update();
  progress.throwIfCancelled();
  if (smoothness <= 0.0) return edges->GetOutput();
  vtkNew<vtkWindowedSincPolyDataFilter> smooth;
  quiet.listen(*smooth, &progress);
  smooth->SetInputData(edges->GetOutput());
  // The range that 3D Slicer's slider has, so that the same number means the same there.
  smooth->SetNumberOfIterations(20 + int(std::lround(40.0 * smoothness)));
  smooth->SetPassBand(std::pow(10.0, -4.0 * smoothness));
  smooth->BoundarySmoothingOff();
  smooth->FeatureEdgeSmoothingOff();
  smooth->NonManifoldSmoothingOn();
  smooth->NormalizeCoordinatesOn();
  smooth->Update();
  progress.throwIfCancelled();
  keepNear(*edges->GetOutput()->GetPoints(), *smooth->GetOutput()->GetPoints(), kMostMoved * smoothness);
  return smooth->GetOutput();
}

Shape shapeOf(vtkPolyData* surface, const glm::dmat4& worldFromVoxel) {
  Shape shape;
  shape.positions.resize(std::size_t(surface->GetNumberOfPoints()));
  for (std::size_t i = 0; i < shape.positions.size(); ++i) {
    double p[3];
    surface->GetPoint(vtkIdType(i), p);
    shape.positions[i] = glm::dvec3(worldFromVoxel * glm::dvec4(p[0], p[1], p[2], 1.0));
  }
  bool isMirrored = glm::determinant(glm::dmat3(worldFromVoxel)) < 0;
  vtkNew<vtkIdList> corners;
  vtkCellArray* cells = surface->GetPolys();
  shape.indices.reserve(std::size_t(cells->GetNumberOfCells()) * 3);
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i) {
    cells->GetCellAtId(i, corners);
    for (vtkIdType c : {0, isMirrored ? 2 : 1, isMirrored ? 1 : 2})
      shape.indices.push_back(std::uint32_t(corners->GetId(c)));
  }
  return shape;
}

/// What the shape gains when a point moves: a third of the areas around it, along their normals.
std::vector<glm::dvec3> gains(const Shape& shape, double& volume) {
  std::vector<glm::dvec3> sums(shape.positions.size(), glm::dvec3(0.0));
  volume = 0.0;
  glm::dvec3 near = shape.positions[0];  // or far from the origin digits would be lost
  for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
    const std::uint32_t* corner = &shape.indices[i];
    glm::dvec3 a = shape.positions[corner[0]] - near, b = shape.positions[corner[1]] - near,
               c = shape.positions[corner[2]] - near;
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

/// Moves the points along their normals until the shape encloses a volume: between voxels the surface cuts corners, and
/// smoothing takes from what is small. @param most  how far at most, in units of the world
void keepVolume(Shape& shape, double wanted, double most) {
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

}  // namespace

Mesh extractSurface(const LabelVolume& labels, std::uint16_t structure, glm::ivec3 low, glm::ivec3 high,
                    double smoothness, Progress& progress) {
  std::uint64_t voxels = 0;
  auto mask = maskOf(labels, structure, low, high - low + 1, voxels);
  if (voxels == 0) throw InputError(fmt::format("structure {} has no voxels, and so no surface", structure));
  const glm::dmat4& m = labels.worldFromVoxel();
  Shape shape = shapeOf(surfaceOf(mask, std::min(smoothness, 1.0), progress), m);
  glm::dmat3 axes(m);
  double longest = std::max({glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])});
  keepVolume(shape, double(voxels) * std::abs(glm::determinant(axes)), (0.5 + kMostMoved * smoothness) * longest);

  Mesh mesh;
  mesh.indices = std::move(shape.indices);
  double volume = 0.0;
  for (const glm::dvec3& sum : gains(Shape{shape.positions, mesh.indices}, volume))
    mesh.normals.push_back(glm::vec3(unitOf(sum)));
  for (const glm::dvec3& p : shape.positions) mesh.positions.push_back(glm::vec3(p));
  for (const LabelInfo& label : labels.table)
    if (label.id == structure) mesh.name = label.name, mesh.color = label.color;
  return mesh;
}

}  // namespace velum::io
