#include "io/meshes/GltfWriter.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/read/GltfFile.h"

namespace velum::io {

namespace {

using namespace gltf;

bool hasNormals(const Mesh& mesh) { return mesh.normals.size() == mesh.positions.size(); }

void addMesh(GltfJson& gltf, Buffers& buffers, const Mesh& mesh) {
  std::size_t points = mesh.positions.size();
  GltfJson attributes = {{"POSITION", buffers.addPositions(mesh.positions)}};
  if (hasNormals(mesh)) attributes["NORMAL"] = buffers.add(points * 12, points, "VEC3", kFloat, kVertices);
  std::size_t corners = mesh.indices.size() / 3 * 3;
  std::size_t indices = buffers.add(corners * 4, corners, "SCALAR", kUInt32, kIndices);
  gltf["materials"].push_back(materialOf(mesh.name, mesh.color.value_or(glm::vec3(0.8f)), 0.6));
  std::size_t number = gltf["meshes"].size();
  gltf["meshes"].push_back(
      {{"name", mesh.name},
       {"primitives", GltfJson::array({{{"attributes", attributes}, {"indices", indices}, {"material", number}}})}});
  gltf["nodes"].push_back({{"name", mesh.name}, {"mesh", number}});
  gltf["nodes"][0]["children"].push_back(number + 1);
}

GltfJson headOf(LengthUnit unit) {
  double metres = millimetresPer(unit) * 1e-3, half = std::sqrt(0.5);
  return {{"asset", {{"version", "2.0"}, {"generator", "Velum"}}},
          {"scene", 0},
          {"scenes", GltfJson::array({{{"nodes", {0}}}})},
          {"nodes", GltfJson::array({{{"name", "patient"},
                                      {"rotation", {-half, 0.0, 0.0, half}},
                                      {"scale", {metres, metres, metres}},
                                      {"children", GltfJson::array()}}})},
          {"meshes", GltfJson::array()},
          {"materials", GltfJson::array()},
          {"accessors", GltfJson::array()},
          {"bufferViews", GltfJson::array()}};
}

}  // namespace

void writeGltf(std::span<const Mesh> meshes, LengthUnit unit, ReplaceFile& file) {
  GltfJson gltf = headOf(unit);
  Buffers buffers(gltf);
  for (const Mesh& mesh : meshes) addMesh(gltf, buffers, mesh);
  writeHead(gltf, buffers, file, "the surfaces do not fit into the 4 GB of a glTF file; write fewer structures");
  for (const Mesh& mesh : meshes) {
    writeAll(file, mesh.positions);
    if (hasNormals(mesh)) writeAll(file, mesh.normals);
    file.write(std::as_bytes(std::span(mesh.indices).first(mesh.indices.size() / 3 * 3)));
  }
}

}  // namespace velum::io
