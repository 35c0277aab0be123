#include "velum/session/picture/Export.h"

#include <fmt/format.h>

#include "velum/core/Error.h"
#include "velum/gpu/Context.h"
#include "velum/io/meshes/WriteMesh.h"
#include "velum/io/volumes/WriteVolume.h"
#include "velum/session/membrane/Membranes.h"

namespace velum::session {

void exportSheets(const scene::Scene& settled, const std::vector<int>& cuts, const std::filesystem::path& path) {
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    std::filesystem::path name(path);
    if (cuts.size() > 1)
      name.replace_filename(fmt::format("{}-{}{}", path.stem().string(), i, path.extension().string()));
    const scene::Cut* cut = scene::findCut(settled, cuts[i]);
    if (!cut || !scene::isMembrane(*cut)) throw ArgumentError(fmt::format("there is no membrane with id {}", cuts[i]));
    io::writeMesh(sheetMesh(*cut), name);
  }
}

void exportClippedVolume(const scene::Scene& settled, const std::filesystem::path& path, Progress& progress) {
  io::writeVolume(clippedVolume(settled, progress), path, progress);
}

scene::Scene settledHeadless(const scene::Scene& scene, Progress& progress) {
  scene::Scene settled = scene;
  if (!hasMembranes(scene)) return settled;
  auto context = gpu::Context::create(gpu::ContextKind::Auto);
  settleMembranes(settled, {}, progress);
  return settled;
}

}  // namespace velum::session
