#include "scene/ModelLayer.h"

#include <algorithm>

#include "core/Links.h"
#include "scene/TypePalette.h"

namespace velum::scene {

std::vector<glm::vec3> typeColors(const ModelLayer& layer) {
  if (!layer.data) return {};
  const Model& model = *layer.data;
  std::vector<glm::vec3> colors = paletteColors(model, layer.palette);
  if (layer.types.empty()) return colors;
  for (std::size_t i = 0; i < colors.size(); ++i)
    if (auto look = typeLook(layer, pathOf(model, model.types[i])); look.color) colors[i] = *look.color;
  return colors;
}

std::string whyOneColor(const ModelLayer& layer) {
  if (!layer.data || layer.palette != Palette::Function || knowsFunctions(*layer.data)) return {};
  return "The file says of no type what it does, so that all are grey: choose the palette by type or by compartment";
}

bool hasGhosts(const ModelLayer& layer) {
  if (layer.ghostOpacity <= 0.0) return false;
  auto shows = [&](const TypeLook& look) { return look.visible && ghostsOf(layer, look) != Ghosts::None; };
  return layer.ghosts != Ghosts::None || std::any_of(layer.types.begin(), layer.types.end(), shows);
}

TypeLook typeLook(const ModelLayer& layer, std::string_view path) {
  auto found =
      std::find_if(layer.types.begin(), layer.types.end(), [&](const TypeLook& look) { return look.type == path; });
  if (found != layer.types.end()) return *found;
  TypeLook look;
  look.type = path;
  return look;
}

std::string ownName(const ModelLayer& layer, std::string_view path) {
  for (const TypeLook& look : layer.types)
    if (look.type == path) return look.name;
  return {};
}

void dropNames(ModelLayer& layer) {
  for (TypeLook& look : layer.types) look.name.clear();
  std::erase_if(layer.types, [](const TypeLook& look) { return look == TypeLook{.type = look.type}; });
}

std::string shownName(const ModelLayer& layer, std::string_view path, std::string_view inFile) {
  if (std::string own = ownName(layer, path); !own.empty()) return own;
  std::string name = withoutLinks(inFile);
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

CopyGrid copyGrid(const ModelLayer& layer) {
  CopyGrid grid;
  if (!layer.data) return grid;
  int copies = std::clamp(layer.copies, 1, kMostCopies);
  int edge = 1;
  while (edge * edge * edge < copies) ++edge;
  grid.counts.x = edge;
  grid.counts.y = std::min(edge, (copies + edge - 1) / edge);
  grid.counts.z = (copies + edge * grid.counts.y - 1) / (edge * grid.counts.y);
  grid.step = glm::dvec3(layer.data->high) - glm::dvec3(layer.data->low);
  return grid;
}

ModelBox modelBox(const ModelLayer& layer) {
  if (!layer.data) return {};
  CopyGrid grid = copyGrid(layer);
  glm::dvec3 low(layer.data->low), high(layer.data->high);
  return {low, high + grid.step * glm::dvec3(glm::max(grid.counts - 1, 0))};
}

}  // namespace velum::scene
