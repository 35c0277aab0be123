#include "membrane/sheet/SheetIndex.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/Vectors.h"
#include "shared/sheet.h"

namespace velum::membrane {

namespace {

using scene::SheetShape;

SheetShape flatShape(glm::ivec2 particles, glm::vec3 half) {
  SheetShape shape{glm::max(particles, glm::ivec2(2)), {}};
  shape.places.reserve(std::size_t(shape.particles.x) * std::size_t(shape.particles.y));
  for (int y = 0; y < shape.particles.y; ++y)
    for (int x = 0; x < shape.particles.x; ++x)
      shape.places.emplace_back(half.x * (2.0f * float(x) / float(shape.particles.x - 1) - 1.0f),
                                half.y * (2.0f * float(y) / float(shape.particles.y - 1) - 1.0f), 0.0f);
  return shape;
}

bool makesSense(const SheetShape& shape) {
  glm::ivec2 n = shape.particles;
  if (n.x < 2 || n.y < 2 || shape.places.size() != std::size_t(n.x) * std::size_t(n.y)) return false;
  auto isFinite = [](glm::vec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); };
  glm::vec3 extent = shape.places.back() - shape.places.front();
  return extent.x > 0 && extent.y > 0 && std::all_of(shape.places.begin(), shape.places.end(), isFinite);
}

shared::SheetPlan planOf(const SheetIndex& index) {
  return {{0, index.particles, 0}, glm::vec3(solidEdges(index.size) * 0.5), 1.0f};
}

/// Unit normals of the particles: the mean over the triangles around each, by area.
void addNormals(SheetIndex& index) {
  glm::ivec2 n = index.particles;
  std::size_t count = std::size_t(n.x) * std::size_t(n.y);
  std::vector<glm::vec3> normals(count, glm::vec3(0.0f));
  auto place = [&](std::size_t v) { return glm::vec3(index.rows[v]); };
  auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    glm::vec3 normal = glm::cross(place(b) - place(a), place(c) - place(a));
    for (std::size_t v : {a, b, c}) normals[v] += normal;
  };
  for (int y = 0; y + 1 < n.y; ++y)
    for (int x = 0; x + 1 < n.x; ++x) {
      std::size_t v = std::size_t(y) * std::size_t(n.x) + std::size_t(x), above = v + std::size_t(n.x);
      add(v, v + 1, above + 1);
      add(v, above + 1, above);
    }
  for (std::size_t v = 0; v < count; ++v) {
    float length = glm::length(normals[v]);
    index.rows[count + v] = glm::vec4(length > 0 ? normals[v] / length : glm::vec3(0, 0, 1), 0.0f);
  }
}

/// Calls visit(cell, mesh, low, high) for each mesh and each cell that it may touch.
void visitCells(const SheetIndex& index, auto&& visit) {
  shared::SheetPlan plan = planOf(index);
  glm::ivec2 n = index.particles;
  for (int y = 0; y + 1 < n.y; ++y)
    for (int x = 0; x + 1 < n.x; ++x) {
      std::size_t v = std::size_t(y) * std::size_t(n.x) + std::size_t(x);
      glm::vec3 low(std::numeric_limits<float>::max()), high(std::numeric_limits<float>::lowest());
      for (std::size_t corner : {v, v + 1, v + std::size_t(n.x), v + std::size_t(n.x) + 1}) {
        low = glm::min(low, glm::vec3(index.rows[corner]));
        high = glm::max(high, glm::vec3(index.rows[corner]));
      }
      glm::ivec4 cells = shared::sheetCellsWithin(plan, glm::vec2(low), glm::vec2(high));
      for (int cy = cells.y; cy <= cells.w; ++cy)
        for (int cx = cells.x; cx <= cells.z; ++cx) visit(std::size_t(cy * n.x + cx), v, low, high);
    }
}

}  // namespace

SheetShape fitShape(const SheetShape& shape, glm::ivec2 flat, glm::dvec3 size) {
  glm::vec3 half(solidEdges(size) * 0.5);
  if (!makesSense(shape)) return flatShape(flat, half);
  SheetShape rim = flatShape(shape.particles, half), fitted = shape;
  glm::vec2 low(shape.places.front()), high(shape.places.back()), scale = 2.0f * glm::vec2(half) / (high - low);
  // What hangs in this very frame stays as it is, to the last bit.
  bool isMadeForIt = low == -glm::vec2(half) && high == glm::vec2(half);
  for (int y = 0; y < shape.particles.y; ++y)
    for (int x = 0; x < shape.particles.x; ++x) {
      std::size_t v = std::size_t(y) * std::size_t(shape.particles.x) + std::size_t(x);
      bool isRim = x == 0 || y == 0 || x + 1 == shape.particles.x || y + 1 == shape.particles.y;
      glm::vec3 p = shape.places[v];
      if (!isMadeForIt) p = glm::vec3((glm::vec2(p) - low) * scale - glm::vec2(half), p.z);
      fitted.places[v] = isRim ? rim.places[v] : glm::clamp(p, -half, half);
    }
  return fitted;
}

SheetIndex makeSheetIndex(const SheetShape& shape, glm::ivec2 flat, glm::dvec3 size) {
  SheetShape fitted = fitShape(shape, flat, size);
  SheetIndex index{fitted.particles, size, {}};
  std::size_t count = fitted.places.size();
  index.rows.resize(fixedRows(index.particles), glm::vec4(0.0f));
  for (std::size_t v = 0; v < count; ++v) index.rows[v] = glm::vec4(fitted.places[v], 0.0f);
  addNormals(index);
  // Count, sum up, fill: meshes in ascending order.
  std::vector<std::size_t> ends(count + 1, 0);
  visitCells(index, [&](std::size_t cell, std::size_t, glm::vec3, glm::vec3) { ++ends[cell + 1]; });
  for (std::size_t cell = 0; cell < count; ++cell) ends[cell + 1] += ends[cell];
  glm::vec4* cells = &index.rows[2 * count];
  for (std::size_t cell = 0; cell < count; ++cell)
    cells[cell] = {float(ends[cell]), 0, shared::kSheetFar, -shared::kSheetFar};
  std::vector<float> lists((ends.back() + 3) / 4 * 4, 0.0f);
  float slack = shared::sheetSlack(planOf(index));
  visitCells(index, [&](std::size_t cell, std::size_t mesh, glm::vec3 low, glm::vec3 high) {
    glm::vec4& row = cells[cell];
    lists[ends[cell] + std::size_t(row.y)] = float(mesh);
    row = {row.x, row.y + 1, std::min(row.z, low.z - slack), std::max(row.w, high.z + slack)};
  });
  for (std::size_t i = 0; i < lists.size(); i += 4)
    index.rows.emplace_back(lists[i], lists[i + 1], lists[i + 2], lists[i + 3]);
  return index;
}

std::optional<SheetTouch> touchSheet(const SheetIndex& index, glm::dvec3 origin, glm::dvec3 direction) {
  shared::SheetPlan plan = planOf(index);
  // From the sphere about the frame on: floats are not enough for an eye that is far off.
  double radius = 0.5 * glm::length(index.size) * (1.0 + 1e-6);
  double start = std::max(0.0, -glm::dot(origin, direction) - radius);
  glm::dvec3 near = origin + direction * start;
  shared::SheetHit hit = shared::sheetCrossing(plan, glm::vec3(near), glm::vec3(direction), float(-1e-6 * radius),
                                               float(4.0 * radius), {index.rows.data()});
  if (hit.triangle < 0) return std::nullopt;
  SheetTouch touch{near + direction * double(hit.t), glm::dvec2(0.0)};
  glm::ivec3 corners = shared::sheetCorners(plan, hit.triangle);
  glm::vec3 shares = shared::sheetShares(plan, hit.triangle, glm::vec3(touch.place), {index.rows.data()});
  for (int i = 0; i < 3; ++i) {
    glm::dvec2 particle(corners[i] % index.particles.x, corners[i] / index.particles.x);
    touch.share += double(shares[i]) * particle / glm::dvec2(index.particles - 1);
  }
  return touch;
}

bool isAbove(const SheetIndex& index, glm::vec3 place) {
  return shared::sheetIsAbove(planOf(index), place, {index.rows.data()});
}

}  // namespace velum::membrane
