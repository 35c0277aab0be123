#include "io/read/GltfFile.h"

#include <array>
#include <bit>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/Color.h"
#include "io/read/Refuse.h"

namespace velum::io::gltf {

namespace {

constexpr std::uint32_t kMagic = 0x46546c67, kVersion = 2, kJsonChunk = 0x4e4f534a, kBinaryChunk = 0x004e4942;

template <class... Words>
void writeWords(ReplaceFile& file, Words... words) {
  std::array<std::uint32_t, sizeof...(words)> all{std::uint32_t(words)...};
  file.write(std::as_bytes(std::span(all)));
}

GltfJson listOf(const glm::vec3& v) { return {v.x, v.y, v.z}; }

}  // namespace

std::size_t Buffers::add(std::size_t bytes, std::size_t count, const char* type, int component, int target) {
  GltfJson view = {{"buffer", 0}, {"byteOffset", mSize}, {"byteLength", bytes}};
  if (target != kNoTarget) view["target"] = target;
  mGltf["bufferViews"].push_back(view);
  mSize += bytes;
  mGltf["accessors"].push_back({{"bufferView", mGltf["bufferViews"].size() - 1},
                                {"componentType", component},
                                {"count", count},
                                {"type", type}});
  return mGltf["accessors"].size() - 1;
}

std::size_t Buffers::addPositions(const std::vector<glm::vec3>& points) {
  glm::vec3 low = points.front(), high = low;
  for (const glm::vec3& p : points) low = glm::min(low, p), high = glm::max(high, p);
  std::size_t positions = add(points.size() * 12, points.size(), "VEC3", kFloat, kVertices);
  mGltf["accessors"][positions]["min"] = listOf(low);
  mGltf["accessors"][positions]["max"] = listOf(high);
  return positions;
}

GltfJson materialOf(const std::string& name, const glm::vec3& color, double roughness) {
  // Colours of glTF are linear.
  glm::dvec3 linear(linearFromSrgb(double(color.r)), linearFromSrgb(double(color.g)), linearFromSrgb(double(color.b)));
  return {{"name", name},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {linear.r, linear.g, linear.b, 1.0}},
            {"metallicFactor", 0.0},
            {"roughnessFactor", roughness}}}};
}

void writeHead(GltfJson& gltf, const Buffers& buffers, ReplaceFile& file, const std::string& tooMuch) {
  static_assert(std::endian::native == std::endian::little, "glTF is little-endian");
  gltf["buffers"] = GltfJson::array({{{"byteLength", buffers.size()}}});
  std::string text = gltf.dump(-1, ' ', false, GltfJson::error_handler_t::replace);
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::uint64_t total = 12 + 8 + text.size() + 8 + buffers.size();
  if (total > std::numeric_limits<std::uint32_t>::max()) refuse(file.target(), tooMuch);
  writeWords(file, kMagic, kVersion, total, text.size(), kJsonChunk);
  file.write(text);
  writeWords(file, buffers.size(), kBinaryChunk);
}

}  // namespace velum::io::gltf
