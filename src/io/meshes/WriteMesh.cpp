#include "velum/io/meshes/WriteMesh.h"

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

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "read/Losses.h"
#include "read/Refuse.h"
#include "read/VtkQuiet.h"
#include "velum/core/FileName.h"
#include "velum/core/ReplaceFile.h"

namespace velum::io {

namespace {

std::string oneLine(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  return text;
}

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

/// VTK writes to memory: to a file it does not look whether its last bytes arrive.
void writeVtp(const Mesh& mesh, ReplaceFile& file) {
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

/// Writes pieces of some length, not a line at a time.
class Lines {
 public:
  explicit Lines(ReplaceFile& file) : mFile(file) {}

  template <class... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(mText), format, std::forward<Values>(values)...);
    if (mText.size() > kPiece) finish();
  }
  void finish() {
    mFile.write(std::string_view(mText.data(), mText.size()));
    mText.clear();
  }

 private:
  static constexpr std::size_t kPiece = 1 << 18;
  ReplaceFile& mFile;
  fmt::memory_buffer mText;
};

void writeObj(const Mesh& mesh, ReplaceFile& file) {
  Lines lines(file);
  if (!mesh.name.empty()) lines.add("o {}\n", oneLine(mesh.name));
  lines.add("# Velum\n");
  for (glm::vec3 p : mesh.positions) lines.add("v {} {} {}\n", p.x, p.y, p.z);
  bool hasNormals = mesh.normals.size() == mesh.positions.size();
  if (hasNormals)
    for (glm::vec3 n : mesh.normals) lines.add("vn {} {} {}\n", n.x, n.y, n.z);
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    std::uint32_t a = mesh.indices[i] + 1, b = mesh.indices[i + 1] + 1, c = mesh.indices[i + 2] + 1;
    if (hasNormals)
      lines.add("f {0}//{0} {1}//{1} {2}//{2}\n", a, b, c);
    else
      lines.add("f {} {} {}\n", a, b, c);
  }
  lines.finish();
}

template <class T>
std::byte* put(std::byte* to, const T& value) {
  std::memcpy(to, &value, sizeof value);
  return to + sizeof value;
}

void writePly(const Mesh& mesh, ReplaceFile& file) {
  bool hasNormals = mesh.normals.size() == mesh.positions.size();
  std::size_t triangles = mesh.indices.size() / 3;
  std::string head = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment Velum{}\nelement vertex {}\nproperty float x\nproperty float y\n"
      "property float z\n{}element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      mesh.name.empty() ? "" : ": " + oneLine(mesh.name), mesh.positions.size(),
      hasNormals ? "property float nx\nproperty float ny\nproperty float nz\n" : "", triangles);
  constexpr std::size_t kVector = 12, kTriangle = 13;
  std::vector<std::byte> bytes(mesh.positions.size() * kVector * (hasNormals ? 2 : 1) + triangles * kTriangle);
  std::byte* to = bytes.data();
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    to = put(to, mesh.positions[i]);
    if (hasNormals) to = put(to, mesh.normals[i]);
  }
  for (std::size_t i = 0; i < triangles; ++i) {
    to = put(to, std::uint8_t(3));
    for (std::size_t corner = 0; corner < 3; ++corner) to = put(to, mesh.indices[i * 3 + corner]);
  }
  file.write(head);
  file.write(bytes);
}

/// Binary: a head, the count, and of each triangle its normal, its corners and two bytes of nothing.
void writeStl(const Mesh& mesh, ReplaceFile& file) {
  constexpr std::size_t kHead = 80, kTriangle = 50;
  auto count = std::uint32_t(mesh.indices.size() / 3);
  std::vector<std::byte> bytes(kHead + sizeof count + kTriangle * count);
  std::string head = mesh.name.empty() ? "Velum" : "Velum: " + oneLine(mesh.name);
  std::memcpy(bytes.data(), head.data(), std::min(head.size(), kHead));
  put(bytes.data() + kHead, count);
  for (std::size_t i = 0; i < count; ++i) {
    glm::vec3 corners[3];
    for (std::size_t c = 0; c < 3; ++c) corners[c] = mesh.positions[mesh.indices[i * 3 + c]];
    glm::vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (float length = glm::length(normal); length > 0) normal /= length;
    put(put(bytes.data() + kHead + sizeof count + kTriangle * i, normal), corners);
  }
  file.write(bytes);
}

struct MeshWriter {
  std::string_view extension;
  void (*write)(const Mesh&, ReplaceFile&);
  bool keepsNormals;  ///< Of vertices.
};
// A new format is one row.
constexpr MeshWriter kWriters[] = {
    {".obj", writeObj, true},
    {".ply", writePly, true},
    {".vtp", writeVtp, true},
    {".stl", writeStl, false},
};

}  // namespace

std::vector<std::string> writeMesh(const Mesh& mesh, const std::filesystem::path& path) {
  if (mesh.indices.empty()) refuse(path, "an empty surface cannot be written");
  std::string extension = lowerExtension(path);
  for (const MeshWriter& writer : kWriters) {
    if (writer.extension != extension) continue;
    ReplaceFile file(path);
    writer.write(mesh, file);
    file.commit();
    Losses losses;
    bool hasNormals = mesh.normals.size() == mesh.positions.size();
    losses.say(hasNormals && !writer.keepsNormals,
               "normals of points are left out, and with them soft shading: {} has those of triangles", extension);
    return losses.take();
  }
  refuse(path, "surfaces are written as .obj, .ply, .vtp or .stl");
}

}  // namespace velum::io
