#include "session/mark/MarkWords.h"

#include <iterator>

#include "scene/Scene.h"
#include "session/measure/Measure.h"
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
  if (!isMeasuredAtOnce(mark)) return {};
  Progress progress;
  return measure(scene, mark, progress).text;
}

std::string markWords(const scene::Scene& scene, const Mark& mark, const std::string& value) {
  bool isNamed = !mark.text.empty() || mark.kind == MarkKind::Name || mark.kind == MarkKind::Region;
  std::string name = isNamed ? markName(scene, mark) : "";
  if (name.empty() || value.empty()) return name + value;
  return name + (value.find('\n') == value.npos ? "  " : "\n") + value;
}

}  // namespace velum::session
