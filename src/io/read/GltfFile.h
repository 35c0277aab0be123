#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/ReplaceFile.h"

/// Parts shared by the writers of binary glTF 2.0.
namespace velum::io::gltf {

using GltfJson = nlohmann::ordered_json;

constexpr int kFloat = 5126, kUInt16 = 5123, kUInt32 = 5125;       ///< components
constexpr int kNoTarget = 0, kVertices = 34962, kIndices = 34963;  ///< what a view is for

/// Adds buffer views of the binary chunk, and accessors on these views, in the order of the bytes.
class Buffers {
 public:
  explicit Buffers(GltfJson& gltf) : mGltf(gltf) {}
  /// @param bytes  a multiple of four
  /// @return number of the accessor
  std::size_t add(std::size_t bytes, std::size_t count, const char* type, int component, int target);
  /// Adds positions; their accessor also holds the box around them.
  std::size_t addPositions(const std::vector<glm::vec3>& points);
  std::uint64_t size() const { return mSize; }

 private:
  GltfJson& mGltf;
  std::uint64_t mSize = 0;
};

/// A material that is not metal. @param color  sRGB
GltfJson materialOf(const std::string& name, const glm::vec3& color, double roughness);

/// Writes everything that stands before the bytes of the views: header and JSON.
/// @param tooMuch  text of the error when the contents do not fit into 4 GB
/// @throw InputError when they do not fit
void writeHead(GltfJson& gltf, const Buffers& buffers, ReplaceFile& file, const std::string& tooMuch);

template <class T>
void writeAll(ReplaceFile& file, const std::vector<T>& values) {
  file.write(std::as_bytes(std::span(values)));
}

}  // namespace velum::io::gltf
