#include "io/stores/WriteStore.h"

#include <fmt/format.h>

#include "core/FileName.h"
#include "core/ReplaceFile.h"
#include "io/read/FileNames.h"
#include "io/read/Losses.h"
#include "io/stores/StoreWriter.h"
#include "io/stores/ZipWriter.h"

namespace velum::io {

namespace {

bool isArchive(const Path& path) { return lowerExtension(path) == ".ozx"; }

std::vector<std::string> lossesOf(const Volume& head) {
  Losses losses;
  bool isScaled = head.scale != 1.0 || head.offset != 0.0;
  losses.say(!isStraight(head), "how the volume is turned is kept in an attribute that other programs do not know");
  losses.say(isScaled, "values are samples times {} plus {}: other programs will show the samples", head.scale,
             head.offset);
  losses.say(head.isColor, "colours become channels for other programs");
  return losses.take();
}

/// The head of what is written: the source's, at one of its levels, without voxels.
Volume headOf(const VoxelSource& source, int level) {
  const Volume& whole = source.head();
  Volume head;
  head.dims = source.levels()[std::size_t(level)].dims;
  head.worldFromVoxel = source.levels()[std::size_t(level)].worldFromVoxel;
  head.type = whole.type;
  head.channels = whole.channels;
  head.timeSteps = whole.timeSteps;
  head.isColor = whole.isColor;
  head.lengthUnit = whole.lengthUnit;
  head.scale = whole.scale;
  head.offset = whole.offset;
  head.unit = whole.unit;
  head.modality = whole.modality;
  head.isSpacingKnown = whole.isSpacingKnown;
  head.isOrientationKnown = whole.isOrientationKnown;
  head.timeStepSeconds = whole.timeStepSeconds;
  head.name = whole.name;
  head.channelNames = whole.channelNames;
  head.channelColors = whole.channelColors;
  return head;
}

void removeFolder(const Path& folder) {
  std::error_code error;
  std::filesystem::remove_all(folder, error);
  if (error) refuse(folder, fmt::format("cannot be removed: {}", error.message()));
}

}  // namespace

bool isStoreFormat(const Path& path) { return lowerExtension(path) == ".zarr" || isArchive(path); }

bool isUnfinished(const Path& folder) {
  std::error_code error;
  return std::filesystem::is_regular_file(folder / kUnfinishedName, error);
}

Path unfinishedFolder(const Path& path) { return isArchive(path) ? Path(path.string() + ".unfinished") : path; }

void expectStoreWritable(const Path& path) {
  if (isArchive(path)) return expectReplaceable(path);
  std::error_code error;
  if (std::filesystem::exists(path, error) && !isUnfinished(path) && !std::filesystem::is_empty(path, error))
    refuse(path, "is there already; remove it, or give another name");
  Path parent = path.parent_path().empty() ? Path(".") : path.parent_path();
  if (!std::filesystem::is_directory(parent, error)) refuse(path, "its folder does not exist; create it first");
}

std::vector<std::string> writeStore(const VoxelSource& source, const Path& path, const StoreOptions& options,
                                    Progress& progress) {
  expectStoreWritable(path);
  if (isArchive(path) && options.version == OmeVersion::V04)
    refuse(path, "archives are of OME-Zarr 0.5; write a folder (.zarr) of 0.4");
  progress.report(0.0, "Reading samples");
  Volume head = headOf(source, options.level);
  Path folder = unfinishedFolder(path);
  StoreWriter writer(source, head, folder, options, progress);
  writer.begin();
  writer.writeLevels();
  writer.describe(writer.findWindows());
  if (isArchive(path)) {
    ReplaceFile file(path);
    zipFolder(folder, std::string(kUnfinishedName), R"({"ome":{"version":"0.5"}})", file, progress);
    file.commit();
    removeFolder(folder);
  } else {
    std::filesystem::remove(folder / kUnfinishedName);
  }
  progress.report(1.0, "Wrote " + path.filename().string());
  return lossesOf(head);
}

}  // namespace velum::io
