#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/ReplaceFile.h"

/// What writers of glTF 2.0, binary, share.
namespace velum::io::gltf {

using GltfJson = nlohmann::ordered_json;

constexpr int kFloat = 5126, kUInt16 = 5123, kUInt32 = 5125;       ///< components
constexpr int kNoTarget = 0, kVertices = 34962, kIndices = 34963;  ///< what a view is for

/// Views of the binary chunk and accessors on them, in the order of the bytes.
class Buffers {
 public:
  explicit Buffers(GltfJson& gltf) : mGltf(gltf) {}
  /// @param bytes  whole groups of four
  /// @return number of the accessor
  std::size_t add(std::size_t bytes, std::size_t count, const char* type, int component, int target);
  /// The same of positions, whose box the accessor has.
  std::size_t addPositions(const std::vector<glm::vec3>& points);
  std::uint64_t size() const { return mSize; }

 private:
  GltfJson& mGltf;
  std::uint64_t mSize = 0;
};

/// One that is no metal. @param color  sRGB
GltfJson materialOf(const std::string& name, const glm::vec3& color, double roughness);

/// Writes all that is before the bytes of the views.
/// @param tooMuch  what to say when a file of 4 GB is too small
/// @throw InputError when it is
void writeHead(GltfJson& gltf, const Buffers& buffers, ReplaceFile& file, const std::string& tooMuch);

template <class T>
void writeAll(ReplaceFile& file, const std::vector<T>& values) {
  file.write(std::as_bytes(std::span(values)));
}

}  // namespace velum::io::gltf
