#include "session/structure/StructureAreas.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/Assert.h"
#include "core/ImageChannels.h"
#include "core/Text.h"
#include "scene/Scene.h"
#include "session/structure/StructureEdit.h"

namespace velum::session {

namespace {

std::size_t columnOf(const Image& image, const char* name) {
  std::ptrdiff_t column = channelIndex(image, name);
  VELUM_ASSERT(column >= 0, "the picture has the layers structure and instance");
  return std::size_t(column);
}

/// The structure that each pixel shows; 0: none.
std::vector<int> shownStructures(const Image& picture) {
  std::size_t id = columnOf(picture, "id"), instance = columnOf(picture, "instance"), step = picture.channels.size();
  std::vector<int> shown(picture.pixels.size() / step, 0);
  for (std::size_t i = 0; i < shown.size(); ++i)
    if (picture.pixels[i * step + instance] == 0.0f) shown[i] = int(picture.pixels[i * step + id]);
  return shown;
}

}  // namespace

bool isStructureShown(const scene::Scene& scene, int structure) {
  const scene::Structure* row = findStructure(scene, structure);
  return scene.labels.visible && (!row || (row->visible && row->opacity > 0.0));
}

std::vector<StructureArea> structureAreas(const scene::Scene& scene, const std::vector<render::StructureHit>& hits,
                                          const Image& picture) {
  std::vector<int> shown = shownStructures(picture);
  std::map<int, StructureArea> areas;
  auto areaOf = [&](int structure) -> StructureArea& {
    StructureArea& area = areas[structure];
    area.structure = structure;
    return area;
  };
  for (const scene::Structure& structure : scene.labels.structures) areaOf(structure.id);
  for (int structure : shown)
    if (structure != 0) ++areaOf(structure).count[CountOf::Visible];
  std::map<int, bool> canShow;
  for (const render::StructureHit& hit : hits) {
    VELUM_ASSERT(hit.pixel < shown.size(), "the picture is as large as that of the rays");
    if (shown[hit.pixel] == hit.structure) continue;
    auto known = canShow.find(hit.structure);
    if (known == canShow.end()) known = canShow.emplace(hit.structure, isStructureShown(scene, hit.structure)).first;
    ++areaOf(hit.structure).count[hit.isLeft && known->second ? CountOf::Hidden : CountOf::Clipped];
  }
  std::vector<StructureArea> rows;
  for (auto& [id, area] : areas) {
    area.name = structureName(scene, id);
    rows.push_back(std::move(area));
  }
  return rows;
}

std::string areasCsv(const std::vector<StructureArea>& areas) {
  std::string csv = "structure,name," + countColumns() + "\n";
  for (const StructureArea& area : areas)
    csv += fmt::format("{},{},{}\n", area.structure, csvQuoted(area.name), countFields(area.count));
  return csv;
}

}  // namespace velum::session
