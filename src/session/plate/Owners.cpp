#include "session/plate/Owners.h"

#include <algorithm>
#include <map>
#include <utility>

#include "scene/Scene.h"
#include "session/model/ModelEdit.h"
#include "session/structure/StructureEdit.h"

namespace velum::session {

namespace {

/// The names of a compartment and of those around it, without the root's, which is around all.
std::string namesDownTo(const scene::Scene& scene, std::uint32_t compartment) {
  const Model& model = *scene.model.data;
  std::string names;
  for (auto at = std::int32_t(compartment); at >= 0; at = model.compartments[std::size_t(at)].parent) {
    const Compartment& of = model.compartments[std::size_t(at)];
    if (of.parent < 0 && !names.empty()) break;
    std::string name = scene::shownName(scene.model, compartmentPath(model, std::uint32_t(at)), of.name);
    names = names.empty() ? name : name + " / " + names;
  }
  return names;
}

}  // namespace

Owner ownerOf(const scene::Scene& scene, int structure, int type) {
  if (type < 0) return {"", structure > 0 ? structureName(scene, structure) : ""};
  if (!scene.model.data || std::size_t(type) >= scene.model.data->types.size()) return {};
  const MoleculeType& of = scene.model.data->types[std::size_t(type)];
  return {namesDownTo(scene, of.compartment), scene::shownName(scene.model, pathOf(*scene.model.data, of), of.name)};
}

std::vector<vector::Item> itemsOf(std::vector<vector::Stroke> strokes, std::span<const Owner> owners,
                                  const vector::Pen& pen, double widest, double least) {
  std::map<std::pair<Owner, double>, vector::Shape> shapes;
  for (vector::Stroke& stroke : strokes) {
    Owner owner = stroke.id > 0 ? owners[std::size_t(stroke.id) - 1] : Owner{};
    double width = stroke.strength * widest;
    vector::Pen own = pen;
    own.width = std::max(least, width);
    own.opacity *= std::min(1.0, width / least);
    auto shape = shapes.try_emplace({owner, width}, vector::Shape{owner.name, {}, own, {}, owner.group}).first;
    shape->second.outlines.push_back(std::move(stroke.line));
  }
  std::vector<vector::Item> items;
  for (auto& [key, shape] : shapes) items.emplace_back(std::move(shape));
  return items;
}

}  // namespace velum::session
