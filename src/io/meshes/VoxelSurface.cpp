#include "io/meshes/VoxelSurface.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkDiscreteFlyingEdges3D.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <unordered_map>
#include <vector>

#include "core/Error.h"
#include "io/read/VtkQuiet.h"

namespace velum::io {

namespace {

constexpr int kEdge = LabelVolume::kBrickSize;
constexpr int kBlock = 4 * kEdge;  ///< cells of a block along each axis

/// Voxels, both ends included; may reach one voxel beyond the grid.
struct VoxelRange {
  glm::ivec3 low, high;
};

/// 1 in the structure, 0 elsewhere; nothing where it has no voxel.
vtkSmartPointer<vtkImageData> maskOf(const LabelVolume& labels, std::uint16_t structure, const VoxelRange& range) {
  glm::ivec3 size = range.high - range.low + 1;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size.x, size.y, size.z);
  image->SetOrigin(range.low.x, range.low.y, range.low.z);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* to = static_cast<unsigned char*>(image->GetScalarPointer());
  std::fill(to, to + std::size_t(image->GetNumberOfPoints()), static_cast<unsigned char>(0));
  glm::ivec3 first = glm::max(range.low, glm::ivec3(0)), last = glm::min(range.high, labels.dims() - 1);
  glm::ivec3 there = glm::max(last - first + 1, glm::ivec3(0)), offset = first - range.low;
  std::vector<std::uint16_t> plane(std::size_t(there.x) * std::size_t(there.y));
  bool isEmpty = true;
  for (int z = 0; z < there.z; ++z) {
    labels.read({first.x, first.y, first.z + z}, {there.x, there.y, 1}, plane);
    for (int y = 0; y < there.y; ++y)
      for (int x = 0; x < there.x; ++x) {
        if (plane[std::size_t(y) * std::size_t(there.x) + std::size_t(x)] != structure) continue;
        isEmpty = false;
        to[(std::size_t(offset.z + z) * std::size_t(size.y) + std::size_t(offset.y + y)) * std::size_t(size.x) +
           std::size_t(offset.x + x)] = 1;
      }
  }
  return isEmpty ? nullptr : image;
}

/// Points midway between voxels in and out, joined to triangles.
vtkSmartPointer<vtkPolyData> trianglesOf(vtkImageData* mask, Progress* progress) {
  VtkQuiet quiet;
  vtkNew<vtkDiscreteFlyingEdges3D> edges;
  quiet.listen(*edges, progress);
  edges->SetInputData(mask);
  edges->SetNumberOfContours(1);
  edges->SetValue(0, 1);
  edges->ComputeNormalsOff();
  edges->ComputeGradientsOff();
  edges->ComputeScalarsOff();
  edges->Update();
  return edges->GetOutput();
}

/// Joins the triangles of blocks; points that two blocks have are one.
class JoinedShape {
 public:
  explicit JoinedShape(glm::ivec3 dims) : mSize(2.0 * (glm::dvec3(dims) + 2.0)) {}
  SurfaceShape shape;

  void add(vtkPolyData& surface, bool isAlone) {
    std::vector<std::uint32_t> indices(std::size_t(surface.GetNumberOfPoints()));
    for (std::size_t i = 0; i < indices.size(); ++i) {
      glm::dvec3 point;
      surface.GetPoint(vtkIdType(i), &point.x);
      auto next = std::uint32_t(shape.positions.size());
      indices[i] = isAlone ? next : mPoints.try_emplace(keyOf(point), next).first->second;
      if (indices[i] == next) shape.positions.push_back(point);
    }
    vtkNew<vtkIdList> corners;
    vtkCellArray* cells = surface.GetPolys();
    shape.indices.reserve(shape.indices.size() + std::size_t(cells->GetNumberOfCells()) * 3);
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i) {
      cells->GetCellAtId(i, corners);
      for (vtkIdType c = 0; c < 3; ++c) shape.indices.push_back(indices[std::size_t(corners->GetId(c))]);
    }
  }

 private:
  /// Points lie at halves of voxels, from one before the grid on.
  std::uint64_t keyOf(const glm::dvec3& point) const {
    glm::dvec3 at = 2.0 * (point + 1.0);
    return (std::uint64_t(at.z) * std::uint64_t(mSize.y) + std::uint64_t(at.y)) * std::uint64_t(mSize.x) +
           std::uint64_t(at.x);
  }
  glm::dvec3 mSize;
  std::unordered_map<std::uint64_t, std::uint32_t> mPoints;
};

/// False where the voxels of a range are all the structure's, or none is, as far as bricks of one id tell.
bool mayHaveBorder(const LabelVolume& labels, std::uint16_t structure, const VoxelRange& range) {
  glm::ivec3 low = glm::max(range.low, glm::ivec3(0)), high = glm::min(range.high, labels.dims() - 1);
  if (glm::any(glm::greaterThan(low, high))) return false;
  bool hasIn = false, hasOut = low != range.low || high != range.high;
  glm::ivec3 first = low / kEdge, last = high / kEdge, at;
  for (at.z = first.z; at.z <= last.z; ++at.z)
    for (at.y = first.y; at.y <= last.y; ++at.y)
      for (at.x = first.x; at.x <= last.x; ++at.x) {
        const LabelVolume::Brick& brick = labels.brick(at);
        bool holds = std::find(brick.begin(), brick.end(), structure) != brick.end();
        hasIn = hasIn || holds;
        hasOut = hasOut || brick.size() > 1 || !holds;
        if (hasIn && hasOut) return true;
      }
  return false;
}

}  // namespace

SurfaceShape voxelSurface(const LabelVolume& labels, std::uint16_t structure, glm::ivec3 low, glm::ivec3 high,
                          Progress& progress, double mostAtOnce) {
  JoinedShape joined(labels.dims());
  VoxelRange all{low - 1, high + 1};  // with a border of what is not the structure's
  glm::dvec3 size(all.high - all.low + 1);
  bool isWhole = size.x * size.y * size.z <= mostAtOnce;
  glm::ivec3 cells = all.high - all.low, block = isWhole ? cells : glm::ivec3(kBlock);
  glm::ivec3 blocks = (cells + block - 1) / block, at;
  for (at.z = 0; at.z < blocks.z; ++at.z)
    for (at.y = 0; at.y < blocks.y; ++at.y)
      for (at.x = 0; at.x < blocks.x; ++at.x) {
        progress.throwIfCancelled();
        VoxelRange range;
        range.low = all.low + at * block;
        range.high = glm::min(range.low + block, all.high);  // blocks share a layer of voxels, and no cell
        if (!isWhole && !mayHaveBorder(labels, structure, range)) continue;
        auto mask = maskOf(labels, structure, range);
        if (mask) joined.add(*trianglesOf(mask, isWhole ? &progress : nullptr), isWhole);
        progress.throwIfCancelled();
        if (!isWhole) progress.report(double(at.z) / blocks.z, "Surface");
      }
  if (joined.shape.indices.empty())
    throw InputError(fmt::format("structure {} has no voxels, and so no surface", structure));
  return std::move(joined.shape);
}

}  // namespace velum::io
