#include "app/StoreInfo.h"

#include <filesystem>

#include "io/stores/OpenStore.h"
#include "io/volumes/ReadLevel.h"

namespace velum::app {

namespace {

Json describeStored(const io::StoreSource& source, int number) {
  const io::StoredLevel& stored = source.facts().levels[std::size_t(number)];
  Json json = describeLevel(source, number);
  json["path"] = stored.key;
  json["storedType"] = io::nameOf(stored.type);
  json["chunk"] = stored.chunk;
  json["codec"] = stored.packing;
  if (!stored.shard.empty()) json["shard"] = stored.shard;
  return json;
}

Json describeChannels(const io::StoreSource& source) {
  const Volume& head = source.head();
  Json channels = Json::array();
  for (std::size_t i = 0; i < head.channelNames.size(); ++i) {
    Json channel = {{"name", head.channelNames[i]}};
    if (!head.channelColors.empty()) channel["color"] = listOf(head.channelColors[i], 3);
    if (!source.channelWindows().empty()) channel["window"] = listOf(source.channelWindows()[i], 2);
    channels.push_back(channel);
  }
  return channels;
}

}  // namespace

Json describeLevel(const VoxelSource& source, int number) {
  const VoxelLevel& level = source.levels()[std::size_t(number)];
  double mm = unitsPer(source.head().lengthUnit, LengthUnit::Millimetre);
  glm::dmat3 axes(level.worldFromVoxel);
  glm::dvec3 spacing(glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]));
  return {{"dims", listOf(level.dims, 3)},
          {"spacingMm", listOf(spacing * mm, 3)},
          {"originMm", listOf(glm::dvec3(level.worldFromVoxel[3]) * mm, 3)},
          {"bytes", levelBytes(source, number)}};
}

Json describeStore(const scene::Source& source) {
  auto image = io::openImage(source.path, source.series);
  const Volume& head = image->head();
  Json levels = Json::array();
  for (int i = 0; i < int(image->levels().size()); ++i) levels.push_back(describeStored(*image, i));
  Json json = {{"kind", image->facts().isLabels ? "labels" : "volume"},
               {"name", head.name.empty() ? std::filesystem::path(source.path).filename().string() : head.name},
               {"dims", listOf(head.dims, 3)},
               {"type", image->facts().isLabels ? io::nameOf(image->facts().levels.front().type)
                                                : std::string(enumName(head.type))},
               {"spacingMm", listOf(spacingOf(head) * unitsPer(head.lengthUnit, LengthUnit::Millimetre), 3)},
               {"unitInFile", image->facts().unit},
               {"axes", image->facts().axes},
               {"channels", head.channels},
               {"frames", head.timeSteps},
               {"frameSeconds", head.timeStepSeconds},
               {"spacingKnown", head.isSpacingKnown},
               {"levels", levels},
               {"levelsAlignedByBorders", image->facts().isAlignedByBorders},
               {"channelList", describeChannels(*image)}};
  std::vector<std::string> warnings = head.warnings;
  try {
    io::LevelPlan plan = io::planLevel(*image, source);
    json["levelRead"] = plan.level;
    json["isStreamed"] = plan.isStreamed;
  } catch (const InputError& error) {
    warnings.push_back(error.what());
  }
  json["warnings"] = warnings;
  return json;
}

}  // namespace velum::app
