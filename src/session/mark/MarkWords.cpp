#include "session/mark/MarkWords.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scene/Scene.h"
#include "scene/Units.h"
#include "session/model/ModelEdit.h"
#include "session/structure/StructureEdit.h"

namespace velum::session {

namespace {

using scene::Mark;
using scene::MarkKind;

/// In the order of MarkKind.
constexpr const char* kTitles[] = {"Distance", "Angle",  "Path", "Area",   "Arrow",  "Label",
                                   "Name",     "Circle", "Box",  "Region", "Profile"};
static_assert(std::size(kTitles) == std::size(EnumNames<MarkKind>::kNames), "each kind has its title");

double lengthOf(const std::vector<glm::dvec3>& points) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) length += glm::distance(points[i - 1], points[i]);
  return length;
}

/// Of a polygon, flat or not: half the length of its vector of area.
double areaOf(const std::vector<glm::dvec3>& points) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 2; i < points.size(); ++i) sum += glm::cross(points[i - 1] - points[0], points[i] - points[0]);
  return 0.5 * glm::length(sum);
}

std::string angleText(const std::vector<glm::dvec3>& p) {
  glm::dvec3 a = p[0] - p[1], b = p[2] - p[1];
  double length = glm::length(a) * glm::length(b);
  if (length == 0.0) return {};
  return fmt::format("{:.1f}\u00b0", glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b))));
}

std::string areaText(const scene::LengthFormat& format, double area) {
  double told = area * format.toldPerLength * format.toldPerLength;
  return fmt::format("{:.{}f} {}\u00b2", told, format.decimals, format.symbol);
}

}  // namespace

const char* markTitle(MarkKind kind) { return kTitles[static_cast<std::size_t>(kind)]; }

std::string markName(const scene::Scene& scene, const Mark& mark) {
  if (!mark.text.empty()) return mark.text;
  if (mark.structure != 0 && (mark.kind == MarkKind::Name || mark.kind == MarkKind::Region))
    return structureName(scene, mark.structure);
  if (mark.kind == MarkKind::Name && !mark.type.empty()) return nameAt(scene, mark.type);
  return markTitle(mark.kind);
}

std::string markValue(const scene::Scene& scene, const Mark& mark) {
  if (mark.points.size() < scene::markPoints(mark.kind).least) return {};
  scene::LengthFormat format = scene::lengthFormat(scene);
  switch (mark.kind) {
    case MarkKind::Distance:
    case MarkKind::Path:
    case MarkKind::Profile:
      return scene::lengthText(format, lengthOf(mark.points));
    case MarkKind::Angle:
      return angleText(mark.points);
    case MarkKind::Area:
      return areaText(format, areaOf(mark.points));
    case MarkKind::Circle:
      return areaText(format, glm::pi<double>() * std::pow(lengthOf(mark.points), 2.0));
    default:
      return {};
  }
}

std::string markWords(const scene::Scene& scene, const Mark& mark) {
  bool isNamed = !mark.text.empty() || mark.kind == MarkKind::Name || mark.kind == MarkKind::Region;
  std::string name = isNamed ? markName(scene, mark) : "", value = markValue(scene, mark);
  return name + (name.empty() || value.empty() ? "" : " ") + value;
}

}  // namespace velum::session
