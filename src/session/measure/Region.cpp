#include "session/measure/Region.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "scene/Scene.h"
#include "session/measure/SurfaceLeft.h"
#include "session/measure/ValueQuantities.h"
#include "session/measure/Values.h"

namespace velum::session {

Measured measureStructure(const scene::Scene& scene, int structure, const StructureLeft& left, Progress& progress) {
  Telling telling = tellingOf(scene);
  Measured measured;
  Quantity volume = volumeQuantity(telling, left.left);
  Quantity share{"share", left.whole > 0.0 ? 100.0 * left.left / left.whole : 0.0, "%", 1};
  double area = left.left > 0.0 ? surfaceLeft(scene, structure, left.low, left.high, progress) : 0.0;
  for (const auto& [cut, face] : left.faces) area += face;
  Quantity surface = areaQuantity(telling, area);
  surface.name = "surface";
  measured.quantities = {volume, share, surface};
  bool isCut = left.left < left.whole * (1.0 - 1e-9);
  measured.text = quantityText(volume) + (isCut ? fmt::format(", {} left", quantityText(share)) : "");
  measured.text += fmt::format("\nsurface {}", quantityText(surface));
  if (!scene.volume.data) return measured;
  StructureValues values = valuesLeft(scene, structure, left.low, left.high, progress);
  if (values.voxels > 0) addValues(measured, *scene.volume.data, values);
  return measured;
}

std::vector<FaceArea> faceAreas(const scene::Scene& scene, int cut, Progress& progress) {
  return faceAreas(measureLeft(scene, 0, progress), cut);
}

std::vector<FaceArea> faceAreas(const std::map<int, StructureLeft>& left, int cut) {
  std::vector<FaceArea> faces;
  for (const auto& [structure, part] : left)
    for (const auto& [by, area] : part.faces)
      if (cut == 0 || by == cut) faces.push_back({by, structure, area});
  std::sort(faces.begin(), faces.end(),
            [](const auto& a, const auto& b) { return std::tie(a.cut, a.structure) < std::tie(b.cut, b.structure); });
  return faces;
}

}  // namespace velum::session
