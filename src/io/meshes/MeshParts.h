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

/// A point of a file as a mesh holds it, in floats. @throw InputError when a coordinate is not a number, or too large
/// for a float
glm::vec3 pointOf(const Path& path, const glm::dvec3& p, std::size_t index);

/// Faces as a file has them, until all points are known.
class Faces {
 public:
  /// Adds a face by its corners, in turn around it; fewer than three corners are ignored.
  void add(std::span<const std::uint32_t> corners);
  /// Adds a strip of triangles, of which each shares two corners with the one before; all face the same way as the
  /// first.
  void addStrip(std::span<const std::uint32_t> corners);
  /// Appends the triangles of all faces to the mesh. A face of more than three corners, convex or not, is divided
  /// within its own plane.
  /// @throw InputError when a corner names a point that is not there
  void moveInto(Mesh& mesh, const Path& path);

 private:
  std::vector<std::uint32_t> mTriangles;
  /// For each face of more than three corners: how many there are, then the corners.
  std::vector<std::uint32_t> mCorners;
};

/// Tells whether all coloured parts of a mesh have the same colour.
class ColorTally {
 public:
  /// @param color  sRGB, 0..1
  void add(const glm::vec3& color);
  /// Gives the mesh the colour that all have, or a warning that the colours differ; does nothing where no colour was
  /// added.
  void putInto(Mesh& mesh) const;

 private:
  std::optional<glm::vec3> mColor;
  bool mDiffer = false;
};

/// Gives each vertex a normal of unit length: the mesh's own where it is usable, else the mean of the normals of the
/// triangles around the vertex, weighted by their angles there.
void completeNormals(Mesh& mesh);

/// The whole file, as text or bytes. @throw InputError
std::vector<char> contentOf(const Path& path);

}  // namespace velum::io
