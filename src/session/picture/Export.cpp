#include "session/picture/Export.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/Error.h"
#include "io/meshes/WriteMesh.h"
#include "io/volumes/WriteVolume.h"
#include "session/membrane/Membranes.h"

namespace velum::session {

std::vector<std::string> exportSheets(const scene::Scene& settled, const std::vector<int>& cuts,
                                      const std::filesystem::path& path) {
  std::vector<std::string> losses;
  if (settled.unit != LengthUnit::Millimetre)
    losses.push_back(fmt::format("lengths are in {}, which no file of surfaces says", enumName(settled.unit)));
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    std::filesystem::path name(path);
    if (cuts.size() > 1)
      name.replace_filename(fmt::format("{}-{}{}", path.stem().string(), i, path.extension().string()));
    const scene::Cut* cut = scene::findCut(settled, cuts[i]);
    if (!cut || !scene::isMembrane(*cut)) throw ArgumentError(fmt::format("there is no membrane with id {}", cuts[i]));
    for (const std::string& line : io::writeMesh(sheetMesh(*cut), name))
      if (std::find(losses.begin(), losses.end(), line) == losses.end()) losses.push_back(line);
  }
  return losses;
}

std::vector<std::string> exportClippedVolume(const scene::Scene& settled, const std::filesystem::path& path,
                                             Progress& progress) {
  auto losses = io::writeVolume(clippedVolume(settled, progress), path, progress);
  if (const Volume& volume = *settled.volume.data; volume.finer)
    losses.push_back(fmt::format("of a streamed volume the level that is in memory is written, {} x {} x {} voxels",
                                 volume.dims.x, volume.dims.y, volume.dims.z));
  if (int count = settled.volume.data->timeSteps; count > 1)
    losses.push_back(fmt::format("of {} time steps the one that is shown is written", count));
  return losses;
}

}  // namespace velum::session
