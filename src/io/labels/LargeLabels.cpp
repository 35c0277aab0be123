#include "io/labels/LargeLabels.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "core/Memory.h"
#include "io/labels/LabelTables.h"
#include "io/labels/ReadLabels.h"
#include "io/read/Placement.h"
#include "io/stores/OpenStore.h"
#include "io/volumes/OpenSource.h"
#include "io/volumes/ReadLevel.h"

namespace velum::io {

namespace {

/// A source of labels, with what else there is to know of it.
struct Opened {
  std::unique_ptr<VoxelSource> source;
  LabelBrickOptions how;
  std::vector<LabelInfo> named;
};

Opened openLabels(const scene::Source& source) {
  Opened opened;
  opened.how.path = source.path;
  if (isStore(source.path)) {
    auto image = openImage(source.path, source.series);
    image->carryIds();
    opened.how.carriesIds = image->carriesIds();
    opened.how.areIdsSigned = image->facts().levels.front().type.kind == ChunkType::Kind::Signed;
    opened.named = image->facts().structures;
    opened.source = std::move(image);
  } else if (auto file = openSource(source); file && file->head().channels == 1) {
    if (levelBytes(*file, 0) > wholeBudget()) opened.source = std::move(file);
  }
  return opened;
}

/// The head of a source as readVolume() has it; on the scan where the file has no place of its own.
Volume placedHead(const Volume& of, const scene::Source& source, const std::optional<LabelGrid>& scan) {
  Volume head = of;
  scene::Source asItIs = source;
  asItIs.spacing = glm::dvec3(0.0);
  completeHead(head, scan ? asItIs : source);
  if (scan && head.dims == scan->dims && hasNoPlace(head, *scan))
    placeOn(head, scan->worldFromVoxel, scan->unit);
  else
    completeHead(head, source);
  return head;
}

/// The table of labels that were read: the names that there are, and those of ids that are others in the file.
void completeNames(LabelVolume& labels, std::vector<LabelInfo> named) {
  std::unordered_map<std::uint64_t, std::uint16_t> ids;
  for (const LabelInfo& info : labels.table) ids[info.fileId] = info.id;
  for (LabelInfo& info : named)
    if (info.fileId != 0) info.id = ids[info.fileId];  // 0, and left out, where no voxel has it
  named.insert(named.end(), labels.table.begin(), labels.table.end());
  labels.table = completeTable(std::move(named), labels.idsInUse());
}

}  // namespace

double labelBudget() {
  // Ids take two bytes here, and a volume of labels one or more.
  return std::max(2.0 * wholeBudget(), brickBudget());
}

LabelVolume labelsByBricks(const VoxelSource& from, const Volume& head, LabelBrickOptions how,
                           std::vector<LabelInfo> named, Progress& progress) {
  if (head.channels > 1)
    refuse(how.path, fmt::format("is no label volume: it has {} samples per voxel", head.channels));
  how.mostBytes = labelBudget();
  how.worldFromFinest = head.worldFromVoxel;
  how.unit = head.lengthUnit;
  LabelVolume labels = readLabelBricks(from, how, progress);
  labels.name = head.name;
  labels.warnings.insert(labels.warnings.begin(), head.warnings.begin(), head.warnings.end());
  if (head.timeSteps > 1)
    labels.warnings.push_back(fmt::format("the file has {} time frames; the first was taken", head.timeSteps));
  completeNames(labels, std::move(named));
  return labels;
}

std::optional<LabelVolume> readLargeLabels(const scene::Source& source, const std::optional<LabelGrid>& scan,
                                           const KnownIds& known, Progress& progress) {
  Opened opened = openLabels(source);
  if (!opened.source) return std::nullopt;
  int levels = int(opened.source->levels().size());
  if (source.level >= levels)
    refuse(source.path, fmt::format("there is no level {}; they are 0 to {}", source.level, levels - 1));
  opened.how.level = std::max(source.level, 0);
  opened.how.mayBeCoarser = source.level < 0;
  opened.how.known = known;
  Volume head = placedHead(opened.source->head(), source, scan);
  return labelsByBricks(*opened.source, head, opened.how, std::move(opened.named), progress);
}

}  // namespace velum::io
