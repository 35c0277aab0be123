#include "io/meshes/VtpWriter.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataWriter.h>

#include "io/Plugins.h"
#include "io/read/Refuse.h"
#include "io/read/VtkQuiet.h"

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
  if (!mesh.name.empty()) {
    vtkNew<vtkStringArray> name;
    name->SetName("name");
    name->InsertNextValue(mesh.name);
    surface->GetFieldData()->AddArray(name);
  }
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

}  // namespace

/// VTK writes to memory: to a file it does not look whether its last bytes arrive.
void plugin::writeVtp(const Mesh& mesh, ReplaceFile& file) {
  VtkQuiet quiet;
  vtkNew<vtkXMLPolyDataWriter> writer;
  quiet.listen(*writer, nullptr);
  writer->WriteToOutputStringOn();
  writer->SetInputData(toPolyData(mesh));
  int written = writer->Write();
  if (written == 0 || !quiet.error().empty())
    refuse(file.target(), fmt::format("cannot be written ({})", quiet.error()));
  file.write(writer->GetOutputString());
}

}  // namespace velum::io
