#include "io/meshes/WriteMesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/FileName.h"
#include "core/ReplaceFile.h"
#include "io/meshes/GltfWriter.h"
#include "io/meshes/VtpWriter.h"
#include "io/read/FileNames.h"
#include "io/read/LineSink.h"
#include "io/read/Losses.h"
#include "io/read/Refuse.h"

namespace velum::io {

namespace {

std::string oneLine(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  return text;
}

bool hasNormals(const Mesh& mesh) { return mesh.normals.size() == mesh.positions.size(); }

/// Calls body(triangle's three corners as numbers over all meshes).
template <class Body>
void forEachTriangle(std::span<const Mesh> meshes, const Body& body) {
  std::uint32_t first = 0;
  for (const Mesh& mesh : meshes) {
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
      body(first + mesh.indices[i], first + mesh.indices[i + 1], first + mesh.indices[i + 2]);
    first += std::uint32_t(mesh.positions.size());
  }
}

/// All in one, with normals where all have them, without colours.
Mesh joined(std::span<const Mesh> meshes, const Path& path) {
  if (meshes.size() == 1) return meshes[0];
  Mesh all;
  all.name = titleOf(path);
  bool haveNormals = std::all_of(meshes.begin(), meshes.end(), hasNormals);
  for (const Mesh& mesh : meshes) {
    all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
    if (haveNormals) all.normals.insert(all.normals.end(), mesh.normals.begin(), mesh.normals.end());
  }
  forEachTriangle(meshes, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    all.indices.insert(all.indices.end(), {a, b, c});
  });
  return all;
}

void writeAsVtp(std::span<const Mesh> meshes, LengthUnit, ReplaceFile& file) {
  writeVtp(joined(meshes, file.target()), file);
}

/// Of points: MeshLab, Blender and others read it behind the place.
void addPoints(LineSink& lines, const Mesh& mesh) {
  if (!mesh.color)
    for (glm::vec3 p : mesh.positions) lines.add("v {} {} {}\n", p.x, p.y, p.z);
  else
    for (glm::vec3 p : mesh.positions)
      lines.add("v {} {} {} {} {} {}\n", p.x, p.y, p.z, mesh.color->r, mesh.color->g, mesh.color->b);
}

void writeObj(std::span<const Mesh> meshes, LengthUnit, ReplaceFile& file) {
  LineSink lines(file);
  std::uint32_t points = 1, normals = 1;
  for (const Mesh& mesh : meshes) {
    if (!mesh.name.empty()) lines.add("o {}\n", oneLine(mesh.name));
    if (points == 1) lines.add("# Velum\n");
    addPoints(lines, mesh);
    if (hasNormals(mesh))
      for (glm::vec3 n : mesh.normals) lines.add("vn {} {} {}\n", n.x, n.y, n.z);
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      std::uint32_t a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
      if (hasNormals(mesh))
        lines.add("f {}//{} {}//{} {}//{}\n", a + points, a + normals, b + points, b + normals, c + points,
                  c + normals);
      else
        lines.add("f {} {} {}\n", a + points, b + points, c + points);
    }
    points += std::uint32_t(mesh.positions.size());
    if (hasNormals(mesh)) normals += std::uint32_t(mesh.positions.size());
  }
  lines.finish();
}

template <class T>
std::byte* put(std::byte* to, const T& value) {
  std::memcpy(to, &value, sizeof value);
  return to + sizeof value;
}

std::array<std::uint8_t, 3> bytesOf(const glm::vec3& color) {
  glm::vec3 c = glm::clamp(color, 0.0f, 1.0f) * 255.0f + 0.5f;
  return {std::uint8_t(c.r), std::uint8_t(c.g), std::uint8_t(c.b)};
}

void writePly(std::span<const Mesh> meshes, LengthUnit, ReplaceFile& file) {
  bool haveNormals = std::all_of(meshes.begin(), meshes.end(), hasNormals);
  bool haveColors = std::any_of(meshes.begin(), meshes.end(), [](const Mesh& m) { return m.color.has_value(); });
  std::size_t points = 0, triangles = 0;
  for (const Mesh& mesh : meshes) points += mesh.positions.size(), triangles += mesh.indices.size() / 3;
  std::string name = meshes.size() == 1 ? meshes[0].name : titleOf(file.target());
  std::string head = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment Velum{}\nelement vertex {}\nproperty float x\nproperty float y\n"
      "property float z\n{}{}element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      name.empty() ? "" : ": " + oneLine(name), points,
      haveNormals ? "property float nx\nproperty float ny\nproperty float nz\n" : "",
      haveColors ? "property uchar red\nproperty uchar green\nproperty uchar blue\n" : "", triangles);
  constexpr std::size_t kVector = 12, kTriangle = 13;
  std::vector<std::byte> bytes(points * (kVector * (haveNormals ? 2 : 1) + (haveColors ? 3 : 0)) +
                               triangles * kTriangle);
  std::byte* to = bytes.data();
  for (const Mesh& mesh : meshes)
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      to = put(to, mesh.positions[i]);
      if (haveNormals) to = put(to, mesh.normals[i]);
      if (haveColors) to = put(to, bytesOf(mesh.color.value_or(glm::vec3(0.8f))));
    }
  forEachTriangle(meshes, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    to = put(put(to, std::uint8_t(3)), std::array{a, b, c});
  });
  file.write(head);
  file.write(bytes);
}

/// Binary: a head, the count, and of each triangle its normal, its corners and two bytes of nothing.
void writeStl(std::span<const Mesh> meshes, LengthUnit, ReplaceFile& file) {
  const Mesh mesh = joined(meshes, file.target());
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

struct Row {
  MeshFormat format;
  void (*write)(std::span<const Mesh>, LengthUnit, ReplaceFile&);
  bool keepsNormals, keepsColors;  ///< Of vertices.
};
// A new format is one row.
constexpr Row kTable[] = {
    {{"STL", ".stl", false}, writeStl, false, false},
    {{"PLY", ".ply", false}, writePly, true, true},
    {{"glTF", ".glb", true}, writeGltf, true, true},
    {{"Wavefront OBJ", ".obj", true}, writeObj, true, true},
    {{"VTK PolyData", ".vtp", false}, writeAsVtp, true, false},
};

constexpr auto kFormats = [] {
  std::array<MeshFormat, std::size(kTable)> formats{};
  for (std::size_t i = 0; i < formats.size(); ++i) formats[i] = kTable[i].format;
  return formats;
}();

const Row* chooseRow(const Path& path) {
  std::string extension = lowerExtension(path);
  auto row = std::find_if(std::begin(kTable), std::end(kTable),
                          [&](const Row& each) { return each.format.extension == extension; });
  return row == std::end(kTable) ? nullptr : row;
}

std::vector<std::string> lossesOf(std::span<const Mesh> meshes, const Row& row) {
  Losses losses;
  losses.say(std::any_of(meshes.begin(), meshes.end(), hasNormals) && !row.keepsNormals,
             "normals of points are left out, and with them soft shading: {} has those of triangles",
             row.format.extension);
  bool haveColors = std::any_of(meshes.begin(), meshes.end(), [](const Mesh& m) { return m.color.has_value(); });
  losses.say(haveColors && !row.keepsColors, "colours are left out: {} is written without", row.format.extension);
  losses.say(meshes.size() > 1 && !row.format.keepsNames, "{} surfaces are written as one, without their names",
             meshes.size());
  return losses.take();
}

}  // namespace

std::span<const MeshFormat> meshFormats() { return kFormats; }

void expectMeshFormat(const Path& path) {
  if (!chooseRow(path)) refuse(path, "surfaces are written as .stl, .ply, .glb, .obj or .vtp");
}

std::vector<std::string> writeMeshes(std::span<const Mesh> meshes, const std::filesystem::path& path, LengthUnit unit) {
  bool isEmpty = std::any_of(meshes.begin(), meshes.end(), [](const Mesh& mesh) { return mesh.indices.empty(); });
  if (meshes.empty() || isEmpty) refuse(path, "an empty surface cannot be written");
  std::uint64_t points = 0;
  for (const Mesh& mesh : meshes) points += mesh.positions.size();
  if (points > std::numeric_limits<std::uint32_t>::max()) refuse(path, "has more points than 32 bits count");
  expectMeshFormat(path);
  const Row* row = chooseRow(path);
  ReplaceFile file(path);
  row->write(meshes, unit, file);
  file.commit();
  return lossesOf(meshes, *row);
}

std::vector<std::string> writeMesh(const Mesh& mesh, const std::filesystem::path& path, LengthUnit unit) {
  return writeMeshes(std::span(&mesh, 1), path, unit);
}

}  // namespace velum::io
