#include "io/meshes/GltfWriter.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "io/read/Refuse.h"

namespace velum::io {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint32_t kMagic = 0x46546c67, kVersion = 2, kJsonChunk = 0x4e4f534a, kBinaryChunk = 0x004e4942;
constexpr int kFloat = 5126, kUInt32 = 5125, kVertices = 34962, kIndices = 34963;

/// glTF's colours are linear.
double linear(float srgb) {
  return srgb <= 0.04045f ? double(srgb) / 12.92 : std::pow((double(srgb) + 0.055) / 1.055, 2.4);
}

/// Views of the binary chunk and accessors on them, in the order of the bytes.
class Buffers {
 public:
  explicit Buffers(Json& gltf) : mGltf(gltf) {}
  /// @return number of the accessor
  std::size_t add(std::size_t bytes, std::size_t count, const char* type, int component, int target) {
    mGltf["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", mSize}, {"byteLength", bytes}, {"target", target}});
    mSize += bytes;  // always whole groups of four
    mGltf["accessors"].push_back({{"bufferView", mGltf["bufferViews"].size() - 1},
                                  {"componentType", component},
                                  {"count", count},
                                  {"type", type}});
    return mGltf["accessors"].size() - 1;
  }
  std::uint64_t size() const { return mSize; }

 private:
  Json& mGltf;
  std::uint64_t mSize = 0;
};

Json listOf(const glm::vec3& v) { return {v.x, v.y, v.z}; }

bool hasNormals(const Mesh& mesh) { return mesh.normals.size() == mesh.positions.size(); }

void addMesh(Json& gltf, Buffers& buffers, const Mesh& mesh) {
  std::size_t points = mesh.positions.size();
  std::size_t positions = buffers.add(points * 12, points, "VEC3", kFloat, kVertices);
  glm::vec3 low = mesh.positions[0], high = low;
  for (const glm::vec3& p : mesh.positions) low = glm::min(low, p), high = glm::max(high, p);
  gltf["accessors"][positions]["min"] = listOf(low);
  gltf["accessors"][positions]["max"] = listOf(high);
  Json attributes = {{"POSITION", positions}};
  if (hasNormals(mesh)) attributes["NORMAL"] = buffers.add(points * 12, points, "VEC3", kFloat, kVertices);
  std::size_t corners = mesh.indices.size() / 3 * 3;
  std::size_t indices = buffers.add(corners * 4, corners, "SCALAR", kUInt32, kIndices);
  glm::vec3 color = mesh.color.value_or(glm::vec3(0.8f));
  gltf["materials"].push_back({{"name", mesh.name},
                               {"pbrMetallicRoughness",
                                {{"baseColorFactor", {linear(color.r), linear(color.g), linear(color.b), 1.0}},
                                 {"metallicFactor", 0.0},
                                 {"roughnessFactor", 0.6}}}});
  std::size_t number = gltf["meshes"].size();
  gltf["meshes"].push_back(
      {{"name", mesh.name},
       {"primitives", Json::array({{{"attributes", attributes}, {"indices", indices}, {"material", number}}})}});
  gltf["nodes"].push_back({{"name", mesh.name}, {"mesh", number}});
  gltf["nodes"][0]["children"].push_back(number + 1);
}

Json headOf(LengthUnit unit) {
  double metres = millimetresPer(unit) * 1e-3, half = std::sqrt(0.5);
  return {{"asset", {{"version", "2.0"}, {"generator", "Velum"}}},
          {"scene", 0},
          {"scenes", Json::array({{{"nodes", {0}}}})},
          {"nodes", Json::array({{{"name", "patient"},
                                  {"rotation", {-half, 0.0, 0.0, half}},
                                  {"scale", {metres, metres, metres}},
                                  {"children", Json::array()}}})},
          {"meshes", Json::array()},
          {"materials", Json::array()},
          {"accessors", Json::array()},
          {"bufferViews", Json::array()}};
}

template <class... Words>
void writeWords(ReplaceFile& file, Words... words) {
  std::array<std::uint32_t, sizeof...(words)> all{std::uint32_t(words)...};
  file.write(std::as_bytes(std::span(all)));
}

}  // namespace

void writeGltf(std::span<const Mesh> meshes, LengthUnit unit, ReplaceFile& file) {
  static_assert(std::endian::native == std::endian::little, "glTF is little-endian");
  Json gltf = headOf(unit);
  Buffers buffers(gltf);
  for (const Mesh& mesh : meshes) addMesh(gltf, buffers, mesh);
  gltf["buffers"] = Json::array({{{"byteLength", buffers.size()}}});
  std::string text = gltf.dump(-1, ' ', false, Json::error_handler_t::replace);
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::uint64_t total = 12 + 8 + text.size() + 8 + buffers.size();
  if (total > std::numeric_limits<std::uint32_t>::max())
    refuse(file.target(), "the surfaces do not fit into the 4 GB of a glTF file; write fewer structures");
  writeWords(file, kMagic, kVersion, total, text.size(), kJsonChunk);
  file.write(text);
  writeWords(file, buffers.size(), kBinaryChunk);
  for (const Mesh& mesh : meshes) {
    file.write(std::as_bytes(std::span(mesh.positions)));
    if (hasNormals(mesh)) file.write(std::as_bytes(std::span(mesh.normals)));
    file.write(std::as_bytes(std::span(mesh.indices).first(mesh.indices.size() / 3 * 3)));
  }
}

}  // namespace velum::io
