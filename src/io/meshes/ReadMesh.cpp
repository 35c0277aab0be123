#include "velum/io/meshes/ReadMesh.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <new>

#include "PlySoundness.h"
#include "read/FileBytes.h"
#include "read/FileNames.h"
#include "read/VtkQuiet.h"
#include "velum/core/Error.h"
#include "velum/core/Text.h"

/// Surfaces. The files have no frame of their own; their numbers are taken as millimetres in LPS, as 3D Slicer and
/// ITK-SNAP write them.
namespace velum::io {

namespace {

/// Counts that a header promises against what the file can hold; VTK allocates on their word.
void checkCounts(const Path& path, std::string_view extension) {
  FileBytes file(path);
  std::string head = file.head(1u << 16);
  if (head.empty()) refuse(path, "is empty");
  auto refuseCount = [&](double count) {
    refuse(path, fmt::format("the header promises {:.0f} elements, more than the file can hold", count));
  };
  auto numberAfter = [&](std::size_t at) {
    std::string_view rest = std::string_view(head).substr(std::min(at, head.size()));
    return takeNumber(rest).value_or(0.0);
  };
  if (extension == ".stl" && !head.starts_with("solid")) {
    std::uint32_t triangles = 0;
    if (head.size() < 84) refuse(path, "is cut short");
    std::memcpy(&triangles, head.data() + 80, 4);
    if (84.0 + 50.0 * triangles > double(file.size())) refuseCount(triangles);
  }
  if (extension == ".vtp") {
    if (head.find("PolyData") == head.npos) refuse(path, "is not a VTK surface (.vtp)");
    for (std::string_view key : {"NumberOfPoints=\"", "NumberOfPolys=\"", "NumberOfStrips=\"", "NumberOfVerts=\"",
                                 "NumberOfLines=\"", "NumberOfTuples=\""})
      for (std::size_t at = 0; (at = head.find(key, at)) != head.npos; at += key.size())
        if (numberAfter(at + key.size()) > 1032.0 * double(file.size())) refuseCount(numberAfter(at + key.size()));
  }
}

template <class Reader>
vtkSmartPointer<vtkPolyData> readWith(const Path& path, Progress& progress) {
  VtkQuiet quiet;
  vtkNew<Reader> reader;
  quiet.listen(*reader, &progress);
  reader->SetFileName(path.c_str());
  reader->Update();
  progress.throwIfCancelled();
  if (!quiet.error().empty()) refuse(path, fmt::format("is damaged ({})", quiet.error()));
  return reader->GetOutput();
}

struct MeshReader {
  std::string_view extension;
  vtkSmartPointer<vtkPolyData> (*read)(const Path&, Progress&);
};
// A new format is one row.
constexpr MeshReader kReaders[] = {
    {".stl", readWith<vtkSTLReader>},
    {".ply", readWith<vtkPLYReader>},
    {".obj", readWith<vtkOBJReader>},
    {".vtp", readWith<vtkXMLPolyDataReader>},
};

vtkSmartPointer<vtkPolyData> readSurface(const Path& path, Progress& progress) {
  std::string extension = lowerExtension(path);
  checkCounts(path, extension);
  if (extension == ".ply") checkPly(path);
  for (const MeshReader& reader : kReaders)
    if (reader.extension == extension) return reader.read(path, progress);
  refuse(path, fmt::format("surfaces are read from {}, not '{}'", fmt::join(meshExtensions(), ", "), extension));
}

/// Triangles only, with a normal at each vertex; the file's own normals are kept.
vtkSmartPointer<vtkPolyData> withNormals(vtkPolyData* surface) {
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(surface);
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->Update();
  if (surface->GetPointData()->GetNormals()) return triangles->GetOutput();
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(triangles->GetOutputPort());
  normals->SplittingOff();
  normals->ConsistencyOff();  // the file's winding is the file's word
  normals->Update();
  return normals->GetOutput();
}

Mesh toMesh(vtkPolyData& surface, const Path& path) {
  Mesh mesh;
  auto points = std::size_t(surface.GetNumberOfPoints());
  vtkDataArray* normals = surface.GetPointData()->GetNormals();
  mesh.positions.resize(points);
  mesh.normals.resize(normals ? points : 0);
  for (std::size_t i = 0; i < points; ++i) {
    double p[3];
    surface.GetPoint(vtkIdType(i), p);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      refuse(path, fmt::format("point {} is not a number", i));
    mesh.positions[i] = {float(p[0]), float(p[1]), float(p[2])};
    if (!normals) continue;
    normals->GetTuple(vtkIdType(i), p);
    glm::vec3 n{float(p[0]), float(p[1]), float(p[2])};
    float length = glm::length(n);
    mesh.normals[i] = length > 0 && std::isfinite(length) ? n / length : glm::vec3(0, 0, 1);
  }
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  auto* cells = surface.GetPolys();
  for (cells->InitTraversal(); cells->GetNextCell(count, ids);) {
    if (count != 3) continue;
    for (int corner = 0; corner < 3; ++corner) {
      if (ids[corner] < 0 || std::size_t(ids[corner]) >= points)
        refuse(path, fmt::format("a triangle names point {}, which is not there", ids[corner]));
      mesh.indices.push_back(std::uint32_t(ids[corner]));
    }
  }
  return mesh;
}

/// A triangle that names a point which is not there would make the filters read outside the file's points.
void checkIndices(vtkPolyData& surface, const Path& path) {
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  for (vtkCellArray* cells : {surface.GetVerts(), surface.GetLines(), surface.GetPolys(), surface.GetStrips()})
    for (cells->InitTraversal(); cells->GetNextCell(count, ids);)
      for (vtkIdType i = 0; i < count; ++i)
        if (ids[i] < 0 || ids[i] >= surface.GetNumberOfPoints())
          refuse(path, fmt::format("a face names point {}, which is not there", ids[i]));
}

}  // namespace

std::span<const std::string_view> meshExtensions() {
  static constexpr auto kExtensions = [] {
    std::array<std::string_view, std::size(kReaders)> all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = kReaders[i].extension;
    return all;
  }();
  return kExtensions;
}

Mesh readMesh(const Path& path, Progress& progress) try {
  progress.report(0, "reading surface");
  VtkQuiet quiet;
  auto surface = readSurface(path, progress);
  checkIndices(*surface, path);
  if (surface->GetNumberOfPoints() > std::numeric_limits<std::uint32_t>::max())
    refuse(path, "has more points than 32 bits count");
  Mesh mesh = toMesh(*withNormals(surface), path);
  if (mesh.indices.empty()) refuse(path, "has no triangles");
  mesh.name = titleOf(path);
  progress.report(1, "reading surface");
  return mesh;
} catch (const std::bad_alloc&) {
  refuse(path, "needs more memory than there is");
} catch (const std::length_error&) {
  refuse(path, "is damaged (a length in it makes no sense)");
}

}  // namespace velum::io
