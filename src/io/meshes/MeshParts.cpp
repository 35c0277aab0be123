#include "io/meshes/MeshParts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "io/read/FileBytes.h"

namespace velum::io {

namespace {

/// Ears are looked for by trying corners against all others; a face of more corners is divided as a fan, and so is what
/// is left of one after so many tries for each pair of its corners.
constexpr std::size_t kMostEars = 1000, kTriesPerPair = 4;

/// Twice the area, along the normal.
glm::dvec3 areaOf(const Mesh& mesh, std::span<const std::uint32_t> corners) {
  glm::dvec3 sum(0.0), first(mesh.positions[corners[0]]);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum +=
        glm::cross(glm::dvec3(mesh.positions[corners[i]]) - first, glm::dvec3(mesh.positions[corners[i + 1]]) - first);
  return sum;
}

/// A face seen along its normal.
class FlatFace {
 public:
  FlatFace(const Mesh& mesh, std::span<const std::uint32_t> corners) {
    glm::dvec3 n = glm::abs(areaOf(mesh, corners)), area = areaOf(mesh, corners);
    int drop = n.x > n.y && n.x > n.z ? 0 : n.y > n.z ? 1 : 2;
    bool isTurned = area[drop] < 0;
    for (std::uint32_t corner : corners) {
      glm::dvec3 p(mesh.positions[corner]);
      glm::dvec2 flat(p[(drop + 1) % 3], p[(drop + 2) % 3]);
      mPoints.push_back(isTurned ? glm::dvec2(flat.y, flat.x) : flat);
    }
  }

  /// Positive when c lies to the left of the way from a to b.
  double turn(std::size_t a, std::size_t b, std::size_t c) const {
    glm::dvec2 ab = mPoints[b] - mPoints[a], ac = mPoints[c] - mPoints[a];
    return ab.x * ac.y - ab.y * ac.x;
  }
  bool isConvex() const {
    std::size_t count = mPoints.size();
    for (std::size_t i = 0; i < count; ++i)
      if (turn(i, (i + 1) % count, (i + 2) % count) < 0) return false;
    return true;
  }
  /// No corner of the ring lies within the triangle, and it does not turn inwards.
  bool isEar(std::span<const std::size_t> ring, std::size_t a, std::size_t b, std::size_t c) const {
    if (!(turn(a, b, c) > 0)) return false;
    return std::none_of(ring.begin(), ring.end(), [&](std::size_t p) {
      return p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
    });
  }

 private:
  std::vector<glm::dvec2> mPoints;
};

void divide(const Mesh& mesh, std::span<const std::uint32_t> corners, std::vector<std::uint32_t>& triangles) {
  std::vector<std::size_t> ring(corners.size());
  for (std::size_t i = 0; i < ring.size(); ++i) ring[i] = i;
  auto put = [&](std::size_t a, std::size_t b, std::size_t c) {
    triangles.insert(triangles.end(), {corners[a], corners[b], corners[c]});
  };
  FlatFace face(mesh, corners);
  bool isFan = corners.size() > kMostEars || face.isConvex();
  std::size_t tries = kTriesPerPair * corners.size() * corners.size();
  for (std::size_t at = 0, missed = 0; !isFan && ring.size() > 3;) {
    std::size_t count = ring.size(), a = at % count, b = (at + 1) % count, c = (at + 2) % count;
    isFan = missed == count || tries < count;  // it crosses itself, or takes too long
    tries -= std::min(tries, count);
    bool isEar = !isFan && face.isEar(ring, ring[a], ring[b], ring[c]);
    missed = isEar ? 0 : missed + 1;
    at = a + 1;
    if (!isEar) continue;
    put(ring[a], ring[b], ring[c]);
    ring.erase(ring.begin() + std::ptrdiff_t(b));
  }
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) put(ring[0], ring[i], ring[i + 1]);
}

float angleAt(const glm::vec3& corner, const glm::vec3& a, const glm::vec3& b) {
  glm::vec3 u = a - corner, v = b - corner;
  float lengths = std::sqrt(glm::dot(u, u) * glm::dot(v, v));
  return lengths > 0 ? std::acos(std::clamp(glm::dot(u, v) / lengths, -1.0f, 1.0f)) : 0.0f;
}

/// The sum over the triangles around each vertex, of any length.
std::vector<glm::vec3> sumNormals(const Mesh& mesh) {
  std::vector<glm::vec3> sums(mesh.positions.size(), glm::vec3(0.0f));
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const std::uint32_t* corner = &mesh.indices[i];
    glm::vec3 p[3] = {mesh.positions[corner[0]], mesh.positions[corner[1]], mesh.positions[corner[2]]};
    glm::dvec3 normal = glm::cross(glm::dvec3(p[1]) - glm::dvec3(p[0]), glm::dvec3(p[2]) - glm::dvec3(p[0]));
    double length = glm::length(normal);
    if (!(length > 0 && std::isfinite(length))) continue;
    for (int c = 0; c < 3; ++c)
      sums[corner[c]] += glm::vec3(normal / length) * angleAt(p[c], p[(c + 1) % 3], p[(c + 2) % 3]);
  }
  return sums;
}

bool isUsable(const glm::vec3& n) {
  float length = glm::length(n);
  return length > 0 && std::isfinite(length);
}

}  // namespace

glm::vec3 pointOf(const Path& path, const glm::dvec3& p, std::size_t index) {
  glm::vec3 point(p);
  if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z))
    refuse(path, fmt::format("point {} is not a number, or too large for one", index));
  return point;
}

void Faces::add(std::span<const std::uint32_t> corners) {
  if (corners.size() < 3) return;
  if (corners.size() > 3) mCorners.push_back(std::uint32_t(corners.size()));
  std::vector<std::uint32_t>& to = corners.size() == 3 ? mTriangles : mCorners;
  to.insert(to.end(), corners.begin(), corners.end());
}

void Faces::addStrip(std::span<const std::uint32_t> corners) {
  for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
    std::uint32_t a = corners[i], b = corners[i + 1], c = corners[i + 2];
    if (a == b || b == c || a == c) continue;  // how strips are joined
    if (i % 2)
      add(std::array{b, a, c});
    else
      add(std::array{a, b, c});
  }
}

void Faces::moveInto(Mesh& mesh, const Path& path) {
  if (mesh.positions.size() > std::numeric_limits<std::uint32_t>::max())
    refuse(path, "has more points than 32 bits count");
  auto check = [&](std::span<const std::uint32_t> corners) {
    for (std::uint32_t corner : corners)
      if (corner >= mesh.positions.size())
        refuse(path, fmt::format("a face names point {}, which is not there", corner));
  };
  check(mTriangles);
  for (std::size_t at = 0; at < mCorners.size();) {
    auto corners = std::span(mCorners).subspan(at + 1, mCorners[at]);
    check(corners);
    divide(mesh, corners, mTriangles);
    at += 1 + corners.size();
  }
  if (mesh.indices.empty())
    mesh.indices = std::move(mTriangles);
  else
    mesh.indices.insert(mesh.indices.end(), mTriangles.begin(), mTriangles.end());
  *this = {};
}

void ColorTally::add(const glm::vec3& color) {
  mDiffer = mDiffer || (mColor && *mColor != color);
  mColor = color;
}

void ColorTally::putInto(Mesh& mesh) const {
  if (mDiffer) mesh.warnings.push_back("its points or faces have colours of their own, which are not shown");
  if (mColor && !mDiffer) mesh.color = glm::clamp(*mColor, 0.0f, 1.0f);
}

void completeNormals(Mesh& mesh) {
  bool isWhole =
      mesh.normals.size() == mesh.positions.size() && std::all_of(mesh.normals.begin(), mesh.normals.end(), isUsable);
  if (!isWhole) {
    std::vector<glm::vec3> sums = sumNormals(mesh);
    mesh.normals.resize(mesh.positions.size(), glm::vec3(0.0f));
    for (std::size_t i = 0; i < sums.size(); ++i)
      if (!isUsable(mesh.normals[i])) mesh.normals[i] = isUsable(sums[i]) ? sums[i] : glm::vec3(0, 0, 1);
  }
  for (glm::vec3& n : mesh.normals) n = glm::normalize(n);
}

std::vector<char> contentOf(const Path& path) {
  FileBytes file(path);
  if (file.size() == 0) refuse(path, "is empty");
  std::vector<char> bytes(std::size_t(file.size()));
  file.read(0, std::as_writable_bytes(std::span(bytes)));
  return bytes;
}

}  // namespace velum::io
