#include "velum/io/meshes/WriteMesh.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkOBJWriter.h>
#include <vtkPLYWriter.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSTLWriter.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataWriter.h>

#include <string>

#include "read/Refuse.h"
#include "read/VtkQuiet.h"
#include "velum/core/ReplaceFile.h"

namespace velum::io {

namespace {

vtkSmartPointer<vtkPolyData> toPolyData(const Mesh& mesh) {
  vtkNew<vtkPoints> points;
  for (glm::vec3 p : mesh.positions) points->InsertNextPoint(double(p.x), double(p.y), double(p.z));
  vtkNew<vtkCellArray> triangles;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    triangles->InsertNextCell(3);
    for (std::size_t corner = 0; corner < 3; ++corner) triangles->InsertCellPoint(mesh.indices[i + corner]);
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  if (mesh.normals.size() == mesh.positions.size()) {
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    for (glm::vec3 n : mesh.normals) normals->InsertNextTuple3(double(n.x), double(n.y), double(n.z));
    surface->GetPointData()->SetNormals(normals);
  }
  return surface;
}

/// @return what went wrong; empty when nothing
template <class Writer>
std::string writeWith(vtkPolyData* surface, const std::filesystem::path& path) {
  VtkQuiet quiet;
  vtkNew<Writer> writer;
  quiet.listen(*writer, nullptr);
  writer->SetFileName(path.c_str());
  writer->SetInputData(surface);
  int written = writer->Write();
  return quiet.error().empty() && written == 0 ? std::string("the disk refuses it") : quiet.error();
}

std::string writeAs(const std::string& extension, vtkPolyData* surface, const std::filesystem::path& path) {
  if (extension == ".obj") return writeWith<vtkOBJWriter>(surface, path);
  if (extension == ".ply") return writeWith<vtkPLYWriter>(surface, path);
  if (extension == ".vtp") return writeWith<vtkXMLPolyDataWriter>(surface, path);
  if (extension == ".stl") return writeWith<vtkSTLWriter>(surface, path);
  return "surfaces are written as .obj, .ply, .vtp or .stl";
}

}  // namespace

void writeMesh(const Mesh& mesh, const std::filesystem::path& path) {
  if (mesh.indices.empty()) refuse(path, "an empty surface cannot be written");
  ReplaceFile file(path);
  std::string error = writeAs(path.extension().string(), toPolyData(mesh), file.temporary());
  if (!error.empty()) refuse(path, error);
  file.commit();
}

}  // namespace velum::io
