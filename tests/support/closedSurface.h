#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/Mesh.h"

/// What can be asked of closed surfaces, by going through all triangles.
namespace velum {

/// Each edge is in two triangles, once each way: the surface is closed, and all of it faces one way.
inline void expectWatertight(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k) ++edges[{mesh.indices[i + k], mesh.indices[i + (k + 1) % 3]}];
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1) << edge.first << " to " << edge.second;
    ASSERT_TRUE(edges.contains({edge.second, edge.first})) << edge.first << " to " << edge.second;
  }
}

/// Points less edges and triangles: 2 for each ball, 0 for each ring.
inline int eulerOf(const Mesh& mesh) {
  auto triangles = int(mesh.indices.size() / 3);
  return int(mesh.positions.size()) - triangles * 3 / 2 + triangles;
}

inline double volumeOf(const Mesh& mesh) {
  double volume = 0;
  glm::dvec3 near(mesh.positions[0]);
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    auto at = [&](std::size_t k) { return glm::dvec3(mesh.positions[mesh.indices[i + k]]) - near; };
    volume += glm::dot(at(0), glm::cross(at(1), at(2))) / 6.0;
  }
  return volume;
}

/// Turns of the surface about a place: 1 inside, 0 outside. [Van Oosterom and Strackee's solid angles]
inline double windingAbout(const Mesh& mesh, const glm::dvec3& place) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    auto at = [&](std::size_t k) { return glm::dvec3(mesh.positions[mesh.indices[i + k]]) - place; };
    glm::dvec3 a = at(0), b = at(1), c = at(2);
    double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    sum += std::atan2(glm::dot(a, glm::cross(b, c)),
                      la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
  }
  return sum / (2.0 * std::acos(-1.0));
}

/// Square of the distance from a place to a triangle.
inline double squareTo(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  glm::dvec3 normal = glm::cross(b - a, c - a);
  auto isLeft = [&](const glm::dvec3& from, const glm::dvec3& to) {
    return glm::dot(glm::cross(to - from, p - from), normal) >= 0.0;
  };
  double area = glm::dot(normal, normal);
  if (area > 0.0 && isLeft(a, b) && isLeft(b, c) && isLeft(c, a)) {
    double off = glm::dot(p - a, normal);
    return off * off / area;
  }
  auto toEdge = [&](const glm::dvec3& from, const glm::dvec3& to) {
    glm::dvec3 way = to - from;
    double length = glm::dot(way, way), t = length > 0.0 ? std::clamp(glm::dot(p - from, way) / length, 0.0, 1.0) : 0.0;
    glm::dvec3 off = p - from - t * way;
    return glm::dot(off, off);
  };
  return std::min({toEdge(a, b), toEdge(b, c), toEdge(c, a)});
}

inline double distanceTo(const Mesh& mesh, const glm::dvec3& place) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    auto at = [&](std::size_t k) { return glm::dvec3(mesh.positions[mesh.indices[i + k]]); };
    least = std::min(least, squareTo(place, at(0), at(1), at(2)));
  }
  return std::sqrt(least);
}

}  // namespace velum
