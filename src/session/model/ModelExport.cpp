#include "session/model/ModelExport.h"

#include <fmt/format.h>

#include <cstdint>
#include <utility>

#include "core/Assert.h"
#include "core/Error.h"
#include "io/models/WriteModel.h"
#include "model/Levels.h"
#include "render/kept/KeptInstances.h"
#include "scene/Crowd.h"
#include "scene/Scene.h"

namespace velum::session {

namespace {

/// What goes along with render::shownModel(), in its order: that of the whole model without what does not show.
struct Along {
  LevelSet levels;
  std::vector<glm::vec3> colors;
  std::vector<std::uint32_t> numbers;
};

void addLevels(LevelSet& to, const LevelSet& from, std::size_t molecule) {
  to.firstLevel.push_back(std::uint32_t(to.levels.size()));
  for (Level level : from.of(molecule)) {
    auto first = from.balls.begin() + level.first;
    level.first = std::uint32_t(to.balls.size());
    to.balls.insert(to.balls.end(), first, first + level.count);
    to.levels.push_back(level);
  }
}

Along alongOf(const scene::ModelLayer& layer, const LevelSet& levels, const std::vector<std::uint8_t>& kept) {
  const Model& model = *layer.data;
  std::vector<glm::vec3> colors = scene::typeColors(layer);
  Along along;
  for (std::size_t t = 0; t < model.types.size(); ++t) {
    const MoleculeType& type = model.types[t];
    if (!scene::typeLook(layer, pathOf(model, type)).visible) continue;
    std::size_t before = along.numbers.size();
    for (std::uint32_t m = type.firstMolecule; m < type.firstMolecule + type.moleculeCount; ++m) {
      const Molecule& molecule = model.molecules[m];
      std::size_t beforeMolecule = along.numbers.size();
      for (std::uint32_t i = molecule.firstInstance; i < molecule.firstInstance + molecule.instanceCount; ++i)
        if (kept[i]) along.numbers.push_back(i);
      if (along.numbers.size() > beforeMolecule) addLevels(along.levels, levels, m);
    }
    if (along.numbers.size() > before) along.colors.push_back(colors[t]);
  }
  along.levels.firstLevel.push_back(std::uint32_t(along.levels.levels.size()));
  return along;
}

bool tellsPartsApart(const scene::ModelLayer& layer) {
  return layer.palette == scene::Palette::Element || layer.palette == scene::Palette::Chain;
}

}  // namespace

bool isModelFile(const std::filesystem::path& path) { return io::isModelWritten(path); }

ModelExport exportModel(const scene::Scene& scene, const std::filesystem::path& path, Progress& progress,
                        const render::SheetIndices& sheets) {
  const scene::ModelLayer& layer = scene.model;
  if (!layer.data) throw InputError("there is no model to export: open one first");
  if (!io::isModelWritten(path))
    throw InputError(fmt::format("{}: models are written as .cif, .cif.gz, .glb, .csv or .ply", path.string()));
  progress.report(0.0, "Choosing instances");
  // Of which the first copy is written.
  scene::Scene first = scene;
  if (scene::isCrowd(scene.model)) first.model.copies = 1;
  std::vector<std::uint8_t> kept = render::keptInstances(first, sheets);
  Model shown = layer.visible ? render::shownModel(scene, kept) : Model{};
  if (shown.instances.empty())
    throw InputError("nothing of the model shows: cuts, or types that are hidden, leave no instance of it");
  bool hasLevels = layer.levels && !model::areQuick(*layer.levels);
  LevelSet made;
  if (!hasLevels) made = model::computeLevels(*layer.data, progress);
  Along along = alongOf(layer, hasLevels ? *layer.levels : made, kept);
  VELUM_ASSERT(along.numbers.size() == shown.instances.size() && along.colors.size() == shown.types.size(),
               "both leave out the same");
  ModelExport out{shown.types.size(), shown.instances.size(), {}};
  io::ModelWriting how{std::move(along.colors), &along.levels, std::move(along.numbers)};
  out.losses = io::writeModel(shown, path, progress, how);
  if (layer.copies > 1)
    out.losses.push_back(fmt::format("of {} copies of the model the first is written", layer.copies));
  if (tellsPartsApart(layer) && path.extension() != ".cif" && path.extension() != ".gz")
    out.losses.push_back("colours are those of types: shades of chains and elements are left out");
  return out;
}

}  // namespace velum::session
