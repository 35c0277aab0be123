#pragma once
#include "core/Vectors.h"
#include "membrane/sheet/SheetIndex.h"
#include "scene/Scene.h"
#include "sheetShapes.h"

/// What cuts leave, written anew in doubles and one by one: by it the fold of the cuts is judged, which all else asks.
namespace velum {

inline constexpr double kTooNear = 0.01;  // floats and doubles may differ about a point on a face
inline constexpr glm::ivec2 kNaiveParticles(14, 17);

/// < 0 inside; what is removed of the plane is its inside.
inline double distanceOfShape(scene::CutShape shape, glm::dvec3 half, glm::dvec3 p) {
  double r = std::hypot(p.x, p.y);
  auto boxed = [](glm::dvec3 q) {
    double outside = glm::length(glm::max(q, glm::dvec3(0.0)));
    return outside > 0 ? outside : std::max(q.x, std::max(q.y, q.z));
  };
  switch (shape) {
    case scene::CutShape::Plane:
      return -p.z;
    case scene::CutShape::Sphere:
      return glm::length(p) - half.x;
    case scene::CutShape::Box:
      return boxed(glm::abs(p) - half);
    case scene::CutShape::Cylinder:
      return boxed({r - half.x, std::abs(p.z) - half.z, -1e9});
    default:
      break;
  }
  double h = 2.0 * half.z;
  double away =
      std::min(distanceToSegment({r, p.z}, {0, 0}, {half.x, h}), distanceToSegment({r, p.z}, {0, h}, {half.x, h}));
  return p.z < h && p.z > 0 && r < half.x * p.z / h ? -away : away;
}

/// How far a point is from what a cut removes, < 0 in it; and how near it is to where that may be doubtful.
struct Place {
  double distance = 0, doubt = 1e9;
};

/// Every triangle of the sheet against the line along z through the point.
inline Place placeOfMembrane(const scene::Cut& cut, const scene::SheetShape& sheet, glm::dvec3 p) {
  Place place;
  glm::dvec2 half = glm::dvec2(cut.size) * 0.5, toRim = half - glm::abs(glm::dvec2(p));
  bool holds = toRim.x > 0 && toRim.y > 0;
  place.doubt = std::min({std::abs(toRim.x), std::abs(toRim.y), std::abs(p.z)});
  double nearest = 1e9, toSheet = std::abs(p.z);
  int over = 0;
  glm::ivec2 n = sheet.particles;
  for (int y = 0; y + 1 < n.y; ++y)
    for (int x = 0; x + 1 < n.x; ++x) {
      auto at = [&](int i, int j) { return glm::dvec3(sheet.places[std::size_t((y + j) * n.x + x + i)]) - p; };
      glm::dvec3 corners[2][3] = {{at(0, 0), at(1, 0), at(1, 1)}, {at(0, 0), at(1, 1), at(0, 1)}};
      for (auto& [a, b, c] : corners) {
        auto cross = [](glm::dvec3 u, glm::dvec3 v) { return u.x * v.y - u.y * v.x; };
        double area = cross(b - a, c - a), u = cross(b, c) / area, v = cross(c, a) / area, w = 1.0 - u - v;
        double least = std::min(u, std::min(v, w));
        if (holds) place.doubt = std::min(place.doubt, 20.0 * std::abs(least));  // on an edge
        if (!holds || least < 0) continue;
        double z = u * a.z + v * b.z + w * c.z;
        over += z > 0;
        place.doubt = std::min(place.doubt, std::abs(z));
        if (std::abs(z) > nearest) continue;
        nearest = std::abs(z);
        glm::dvec3 normal = glm::cross(b - a, c - a);
        toSheet = nearest * std::abs(normal.z) / glm::length(normal);
      }
    }
  bool isAbove = holds ? over % 2 == 0 : p.z > 0;
  bool isInlay = cut.membrane->use == scene::MembraneUse::Inlay;
  bool removes = isInlay ? !holds || isAbove == (p.z > 0) : isAbove != cut.invert;
  double depth = isInlay ? std::min(toSheet, std::abs(p.z)) : toSheet;
  place.distance = removes ? -depth : depth;
  return place;
}

inline Place placeOf(const scene::Cut& cut, glm::dvec3 world) {
  glm::dvec3 p(glm::inverse(scene::worldFromCut(cut)) * glm::dvec4(world, 1.0));
  if (cut.membrane) return placeOfMembrane(cut, membrane::fitShape(cut.membrane->shape, kNaiveParticles, cut.size), p);
  double distance = distanceOfShape(cut.shape, cut.size * 0.5, p) * (cut.invert ? -1.0 : 1.0);
  return {distance, std::abs(distance)};
}

struct Naive {
  bool keeps = true, isDoubtful = false;
};

inline Naive naive(const scene::Scene& scene, glm::dvec3 world, int structure) {
  bool isTaken = false, hasInlay = false, inInlay = false;
  bool group = false, isOpen = false;  // what the cuts that are joined take together; one of them is on
  Naive out;
  for (const auto& cut : scene.cuts) {
    bool isInlay = cut.membrane && cut.membrane->use == scene::MembraneUse::Inlay;
    if (!cut.joined || isInlay) {
      isTaken = isTaken || group;
      group = isOpen = false;
    }
    if (!cut.enabled) continue;
    double depth = 0.0;
    for (auto spare = cut.spares.rbegin(); spare != cut.spares.rend(); ++spare)
      if (spare->structure == structure) depth = spare->distance;
    Place place = placeOf(cut, world);
    out.isDoubtful = out.isDoubtful || place.doubt < kTooNear || std::abs(-place.distance - depth) < kTooNear;
    bool keeps = place.distance >= 0.0 || -place.distance <= depth;
    hasInlay = hasInlay || isInlay;
    inInlay = inInlay || (isInlay && keeps);
    if (isInlay) continue;
    group = (group || !isOpen) && !keeps;
    isOpen = true;
  }
  out.keeps = !isTaken && !group && (!hasInlay || inInlay);
  return out;
}

}  // namespace velum
