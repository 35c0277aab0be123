#include "io/meshes/ThreeWayBorders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "core/Parallel.h"
#include "io/meshes/BorderWay.h"

namespace velum::io {

namespace {

using PointNumbers = std::vector<std::uint32_t>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// A face of a cell, whose corners are the middles of four voxels.
struct Face {
  glm::ivec3 corner{0};  ///< the least of the four
  int axis = 0;          ///< across it
  glm::ivec3 u() const { return unitAlong((axis + 1) % 3); }
  glm::ivec3 v() const { return unitAlong((axis + 2) % 3); }
};

/// Ids of a face's corners: at 0, u, v, u + v.
std::array<std::uint16_t, 4> idsOf(const StructureField& field, const Face& face) {
  return {idAt(field, face.corner), idAt(field, face.corner + face.u()), idAt(field, face.corner + face.v()),
          idAt(field, face.corner + face.u() + face.v())};
}

bool hasThree(std::array<std::uint16_t, 4> ids) {
  std::sort(ids.begin(), ids.end());
  return std::unique(ids.begin(), ids.end()) - ids.begin() > 2;
}

bool hasThree(const StructureField& field, const Face& face) { return hasThree(idsOf(field, face)); }

/// Where three meet in a face.
glm::dvec3 placeIn(const StructureField& field, const Face& face) {
  auto ids = idsOf(field, face);
  int u = (face.axis + 1) % 3, v = (face.axis + 2) % 3;
  auto along = [&](glm::ivec3 from, int axis) { return partOf(field, {from, axis}); };
  auto low = [&] { return along(face.corner, u); };               // along u at v = 0
  auto high = [&] { return along(face.corner + face.v(), u); };   // at v = 1
  auto left = [&] { return along(face.corner, v); };              // along v at u = 0
  auto right = [&] { return along(face.corner + face.u(), v); };  // at u = 1
  glm::dvec2 place(0.0);
  if (ids[0] == ids[1] || ids[2] == ids[3]) {  // one has a side: its border runs across, the others' up to it
    place.x = ids[0] == ids[1] ? high() : low();
    place.y = glm::mix(left(), right(), place.x);
  } else if (ids[0] == ids[2] || ids[1] == ids[3]) {
    place.y = ids[0] == ids[2] ? right() : left();
    place.x = glm::mix(low(), high(), place.y);
  } else {  // one has two corners across, or there are four
    place = 0.25 * glm::dvec2(low() + high() + 1.0, left() + right() + 1.0);
  }
  return glm::dvec3(face.corner) + place.x * glm::dvec3(face.u()) + place.y * glm::dvec3(face.v());
}

std::array<Face, 6> facesOf(glm::ivec3 cell) {
  std::array<Face, 6> faces;
  for (int i = 0; i < 6; ++i) faces[std::size_t(i)] = {cell + i / 3 * unitAlong(i % 3), i % 3};
  return faces;
}

/// The face of cells in which two points on ways lie, if there is one.
std::optional<Face> faceOf(const glm::dvec3& a, const glm::dvec3& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (a[axis] == b[axis] && a[axis] == std::floor(a[axis])) return Face{glm::floor(glm::min(a, b)), axis};
  return {};
}

class Joining {
 public:
  Joining(SurfaceShape& shape, const PointsOnWays& points, const StructureField& field)
      : mShape(shape), mHalfway(points.halfway), mHasThird(points.hasThird), mField(field) {}

  void run() {
    auto cells = takeOut();
    for (const auto& [at, corners] : cells) {
      auto [z, y, x] = at;
      for (const PointNumbers& loop : loopsOf(corners)) fill(loop, middleOf({x, y, z}));
    }
  }

 private:
  using Cells = std::map<std::tuple<int, int, int>, PointNumbers>;

  glm::ivec3 cellOf(std::size_t corner) const {
    const auto& i = mShape.indices;
    return glm::ivec3(
        glm::floor((mHalfway[i[corner]] + mHalfway[i[corner + 1]] + mHalfway[i[corner + 2]]) * (1.0 / 3.0)));
  }

  /// Triangles of cells in one of whose faces three meet: these are made anew.
  Cells takeOut() {
    std::size_t count = mShape.indices.size() / 3;
    std::vector<std::uint8_t> isOut(count, 0);
    parallelFor(std::size_t(0), count, [&](std::size_t i) {
      const std::uint32_t* corner = &mShape.indices[3 * i];
      if (!mHasThird[corner[0]] || !mHasThird[corner[1]] || !mHasThird[corner[2]]) return;
      for (const Face& face : facesOf(cellOf(3 * i))) isOut[i] |= hasThree(mField, face) ? 1 : 0;
    });
    Cells cells;
    std::size_t kept = 0;
    PointNumbers& indices = mShape.indices;
    for (std::size_t i = 0; i < count; ++i) {
      auto corners = indices.begin() + std::ptrdiff_t(3 * i);
      if (isOut[i]) {
        glm::ivec3 cell = cellOf(3 * i);
        PointNumbers& out = cells[{cell.z, cell.y, cell.x}];
        out.insert(out.end(), corners, corners + 3);
      } else {
        std::copy_n(corners, 3, indices.begin() + std::ptrdiff_t(3 * kept++));
      }
    }
    mShape.indices.resize(3 * kept);
    return cells;
  }

  /// Rims of what triangles make up, in their sense of rotation.
  static std::vector<PointNumbers> loopsOf(const PointNumbers& corners) {
    std::map<std::uint32_t, std::uint32_t> next;
    std::map<Edge, bool> edges;
    for (std::size_t i = 0; i < corners.size(); ++i) edges[{corners[i], corners[i % 3 == 2 ? i - 2 : i + 1]}] = true;
    for (const auto& [edge, is] : edges)
      if (!edges.contains({edge.second, edge.first})) next[edge.first] = edge.second;
    std::vector<PointNumbers> loops;
    while (!next.empty()) {
      PointNumbers& loop = loops.emplace_back();
      for (auto at = next.begin(); at != next.end(); at = next.find(loop.back())) {
        std::uint32_t to = at->second;
        next.erase(at);
        loop.push_back(to);
      }
    }
    return loops;
  }

  std::uint32_t add(const glm::dvec3& position, const glm::dvec3& normal) {
    mShape.positions.push_back(position);
    double length = glm::length(normal);
    mShape.normals.push_back(length > 0.0 ? normal / length : glm::dvec3(0, 0, 1));
    return std::uint32_t(mShape.positions.size() - 1);
  }

  glm::dvec3 middleOf(glm::ivec3 cell) const {
    glm::dvec3 sum(0.0);
    int count = 0;
    for (const Face& face : facesOf(cell))
      if (hasThree(mField, face)) sum += placeIn(mField, face), ++count;
    return sum / double(count);
  }

  /// The point on an edge of the surface that lies in a face where three meet.
  std::optional<std::uint32_t> between(std::uint32_t a, std::uint32_t b) {
    auto face = faceOf(mHalfway[a], mHalfway[b]);
    if (!face || !hasThree(mField, *face)) return {};
    auto [known, isNew] = mBetween.try_emplace(Edge(std::min(a, b), std::max(a, b)));
    if (isNew) known->second = add(placeIn(mField, *face), mShape.normals[a] + mShape.normals[b]);
    return known->second;
  }

  void fill(const PointNumbers& loop, const glm::dvec3& middle) {
    PointNumbers rim;
    glm::dvec3 normal(0.0);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      rim.push_back(loop[i]);
      normal += mShape.normals[loop[i]];
      if (auto point = between(loop[i], loop[(i + 1) % loop.size()])) rim.push_back(*point);
    }
    std::uint32_t centre = add(middle, normal);
    for (std::size_t i = 0; i < rim.size(); ++i)
      for (std::uint32_t corner : {centre, rim[i], rim[(i + 1) % rim.size()]}) mShape.indices.push_back(corner);
  }

  SurfaceShape& mShape;
  const std::vector<glm::dvec3>& mHalfway;
  const std::vector<std::uint8_t>& mHasThird;
  const StructureField& mField;
  std::map<Edge, std::uint32_t> mBetween;
};

}  // namespace

void joinWhereThreeMeet(SurfaceShape& shape, const PointsOnWays& points, const StructureField& field) {
  Joining(shape, points, field).run();
}

}  // namespace velum::io
