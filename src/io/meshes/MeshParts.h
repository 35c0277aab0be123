#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/Mesh.h"
#include "io/read/Refuse.h"

/// What the readers of surfaces share.
namespace velum::io {

/// The point as it is held. @throw InputError when it is no number, or too large for one
glm::vec3 pointOf(const Path& path, const glm::dvec3& p, std::size_t index);

/// Faces as a file has them, until all points are known.
class Faces {
 public:
  /// Corners in turn around the face; fewer than three are none.
  void add(std::span<const std::uint32_t> corners);
  /// Triangles of which each shares two corners with the one before; all turn the way the first does.
  void addStrip(std::span<const std::uint32_t> corners);
  /// Puts their triangles behind those of the mesh. A face of more than three corners, convex or not, is divided
  /// within its own plane.
  /// @throw InputError when a corner names a point that is not there
  void moveInto(Mesh& mesh, const Path& path);

 private:
  std::vector<std::uint32_t> mTriangles;
  std::vector<std::uint32_t> mCorners;  ///< Of larger faces: their number, then they.
};

/// Tells whether what was coloured has one colour.
class ColorTally {
 public:
  /// @param color  sRGB, 0..1
  void add(const glm::vec3& color);
  /// The colour of all, or a warning that they differ; nothing where none was added.
  void putInto(Mesh& mesh) const;

 private:
  std::optional<glm::vec3> mColor;
  bool mDiffer = false;
};

/// Normals of unit length for each vertex: the mesh's own where they are usable, else the mean of the triangles around,
/// by their angles.
void completeNormals(Mesh& mesh);

/// The whole file, as text or bytes. @throw InputError
std::vector<char> contentOf(const Path& path);

}  // namespace velum::io
