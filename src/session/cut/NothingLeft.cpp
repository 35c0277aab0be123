#include "session/cut/NothingLeft.h"

#include <algorithm>
#include <vector>

#include "render/kept/KeptInstances.h"
#include "render/kept/KeptVoxels.h"
#include "scene/Crowd.h"
#include "scene/Scene.h"
#include "scene/ShownVoxels.h"

namespace velum::session {

namespace {

constexpr double kLeastOpacity = 1.0 / 255.0;  ///< Of a unit of distance, that anybody sees.
/// Voxels that are looked at, until one is found that is left; the last is all of them.
constexpr double kSamples[] = {3e4, 1e6, 1e18};

enum class Left { Nothing, Something, NothingShows };

/// Of the volume, or of labels alone.
Left voxelsLeft(const scene::Scene& scene, Progress& progress) {
  bool hasFace = std::ranges::any_of(scene::enabledOf(scene.cuts),
                                     [](const scene::Cut& cut) { return cut.face == scene::CutFace::Section; });
  Left left = Left::NothingShows;
  std::size_t before = 0;
  for (double samples : kSamples) {
    scene::ShownVoxels voxels = scene::shownVoxels(scene, samples, kLeastOpacity);
    if (voxels.shown.size() == before) break;
    before = voxels.shown.size();
    if (hasFace) std::fill(voxels.shown.begin(), voxels.shown.end(), std::uint8_t(1));
    std::vector<std::uint8_t> kept = render::keptVoxels(scene, voxels.dims, voxels.worldFromVoxel, progress);
    for (std::size_t i = 0; i < kept.size(); ++i) {
      if (!voxels.shown[i]) continue;
      if (kept[i]) return Left::Something;
      left = Left::Nothing;
    }
  }
  return left;
}

Left instancesLeft(const scene::Scene& scene) {
  if (!scene.model.data || !scene.model.visible) return Left::NothingShows;
  // Nobody looks at all instances of a crowd.
  if (scene::hasGhosts(scene.model) || scene::isCrowd(scene.model)) return Left::Something;
  const Model& model = *scene.model.data;
  std::vector<std::uint8_t> kept = render::keptInstances(scene);
  Left left = Left::NothingShows;
  for (const MoleculeType& type : model.types) {
    if (!scene::typeLook(scene.model, pathOf(model, type)).visible) continue;
    auto first = kept.begin() + std::ptrdiff_t(type.firstInstance);
    if (std::find(first, first + std::ptrdiff_t(type.instanceCount), 1) != first + std::ptrdiff_t(type.instanceCount))
      return Left::Something;
    if (type.instanceCount > 0) left = Left::Nothing;
  }
  return left;
}

}  // namespace

bool cutsTakeAll(const scene::Scene& scene, Progress& progress) {
  bool isCut = !scene::enabledOf(scene.cuts).empty(),
       hasInlay = std::ranges::any_of(scene::enabledOf(scene.cuts), scene::isInlay);
  // An inlay shows its image; a surface beside the data is seldom cut, and nobody asks each of its points.
  bool hasSurface = std::any_of(scene.surfaces.begin(), scene.surfaces.end(),
                                [](const scene::Surface& surface) { return surface.visible && surface.data; });
  if (!isCut || hasInlay || hasSurface) return false;
  Left instances = instancesLeft(scene);
  if (instances == Left::Something) return false;
  bool hasVoxels = (scene.volume.data && scene.volume.visible) || (!scene.volume.data && scene.labels.data);
  Left voxels = hasVoxels ? voxelsLeft(scene, progress) : Left::NothingShows;
  if (voxels == Left::Something) return false;
  return voxels == Left::Nothing || instances == Left::Nothing;
}

}  // namespace velum::session
