#include "session/model/LegendLacks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <unordered_set>
#include <vector>

#include "scene/Scene.h"
#include "session/model/ModelEdit.h"

namespace velum::session {

std::string whatLegendLacks(const scene::Scene& scene) {
  std::unordered_set<std::string> known;
  for (const scene::Structure& structure : scene.labels.structures) known.insert(structure.name);
  if (const auto& model = scene.model.data) {
    for (const MoleculeType& type : model->types) known.insert(pathOf(*model, type));
    for (std::uint32_t i = 0; i < model->compartments.size(); ++i) known.insert(compartmentPath(*model, i));
  }
  std::vector<std::string> lacking;
  for (const std::string& entry : scene.lettering.entries)
    if (!known.contains(entry)) lacking.push_back(entry);
  if (lacking.empty()) return {};
  return fmt::format("the legend leaves out what the data do not have: {}", fmt::join(lacking, ", "));
}

}  // namespace velum::session
