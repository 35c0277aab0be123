#include "velum/io/volumes/WriteVolume.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <functional>

#include "Writers.h"
#include "read/FormatTable.h"
#include "read/Payload.h"

namespace velum::io {

namespace {

void syncToDisk(const Path& path) {
  int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) failInput(path, std::strerror(errno));
  int result = ::fsync(descriptor);
  ::close(descriptor);
  // A folder on some file systems cannot be synced, which is no reason to lose what was written.
  if (result != 0 && errno != EINVAL) failInput(path, std::strerror(errno));
}

/// Writes to a temporary in the same folder, then renames: a crash or a full disk leaves the old file as it was.
void writeAtomically(const Path& path, const std::function<void(const Path&)>& write) {
  Path folder = path.parent_path().empty() ? Path(".") : path.parent_path();
  if (!std::filesystem::is_directory(folder)) failInput(folder, "there is no such folder to write to");
  // The extension stays at the end, for the writers look at it.
  Path temporary = folder / fmt::format(".velum-{}-{}", ::getpid(), path.filename().string());
  try {
    write(temporary);
    syncToDisk(temporary);
    std::filesystem::rename(temporary, path);
    syncToDisk(folder);
  } catch (const std::filesystem::filesystem_error& error) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    failInput(path, error.code().message());
  } catch (const InputError& error) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    // The user knows the file by its own name.
    std::string message = error.what();
    if (auto at = message.find(temporary.string()); at != std::string::npos)
      message.replace(at, temporary.string().size(), path.string());
    throw InputError(message);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw;
  }
}

void checkWhole(const Volume& v, const Path& path) {
  std::size_t wanted = frameBytes(v) * std::size_t(std::max(0, v.frames));
  if (wanted == 0 || v.voxels.size() != wanted) failInput(path, "an empty volume cannot be written");
}

/// The ids as a plain volume, uint8 where they fit, filled slab by slab.
Volume volumeOf(const LabelVolume& labels, Progress& progress) {
  Volume v;
  v.dims = labels.dims();
  auto used = labels.idsInUse();
  v.type = used.empty() || used.back() < 256 ? SampleType::UInt8 : SampleType::UInt16;
  v.worldFromVoxel = labels.worldFromVoxel();
  v.voxels.resize(frameBytes(v));
  std::size_t plane = std::size_t(v.dims.x) * std::size_t(v.dims.y);
  std::vector<std::uint16_t> slab(plane * LabelVolume::kBrickSize);
  for (int z = 0; z < v.dims.z; z += LabelVolume::kBrickSize) {
    int depth = std::min(LabelVolume::kBrickSize, v.dims.z - z);
    std::size_t count = plane * std::size_t(depth), first = std::size_t(z) * plane;
    labels.read({0, 0, z}, {v.dims.x, v.dims.y, depth}, slab);
    if (v.type == SampleType::UInt16)
      std::memcpy(v.voxels.data() + first * 2, slab.data(), count * 2);
    else
      std::transform(slab.begin(), slab.begin() + std::ptrdiff_t(count), v.voxels.begin() + std::ptrdiff_t(first),
                     [](std::uint16_t id) { return std::byte(id); });
    progress.throwIfCancelled();
  }
  return v;
}

std::string oneLine(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

/// 3D Slicer's names for what a segment is.
LabelExtras extrasOf(const LabelVolume& labels) {
  LabelExtras extras;
  auto add = [&](std::size_t i, const char* what, std::string value) {
    extras.nrrdKeyValues.emplace_back(fmt::format("Segment{}_{}", i, what), std::move(value));
  };
  glm::ivec3 last = labels.dims() - 1;
  std::string xml =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<CaretExtension><VolumeInformation Index=\"0\"><LabelTable>\n";
  for (std::size_t i = 0; i < labels.table.size(); ++i) {
    const LabelInfo& label = labels.table[i];
    std::string name = oneLine(label.name);
    add(i, "ID", fmt::format("Segment_{}", label.id));
    add(i, "Name", name);
    add(i, "Color", fmt::format("{} {} {}", label.color.r, label.color.g, label.color.b));
    add(i, "Extent", fmt::format("0 {} 0 {} 0 {}", last.x, last.y, last.z));
    add(i, "LabelValue", fmt::format("{}", label.id));
    add(i, "Layer", "0");
    while (name.find("]]>") != std::string::npos) name.erase(name.find("]]>"), 3);
    xml += fmt::format("<Label Key=\"{}\" Red=\"{}\" Green=\"{}\" Blue=\"{}\" Alpha=\"{}\"><![CDATA[{}]]></Label>\n",
                       label.id, label.color.r, label.color.g, label.color.b, label.opacity, name);
  }
  if (!labels.table.empty()) extras.nrrdKeyValues.emplace_back("Segmentation_MasterRepresentation", "Binary labelmap");
  extras.niftiExtension =
      xml + "</LabelTable><VolumeType><![CDATA[Label]]></VolumeType></VolumeInformation></CaretExtension>\n";
  return extras;
}

}  // namespace

void writeVolume(const Volume& volume, const std::filesystem::path& path, Progress& progress) {
  const FormatRow* row = chooseWriter(path);
  if (!row) failInput(path, "volumes are written as .nrrd, .nii, .nii.gz, .vti or .vdb");
  checkWhole(volume, path);
  writeAtomically(path, [&](const Path& temporary) { row->write(volume, temporary, progress); });
  progress.report(1.0, "Wrote " + path.filename().string());
}

void writeLabels(const LabelVolume& labels, const std::filesystem::path& path, Progress& progress) {
  const FormatRow* row = chooseWriter(path);
  bool isNrrd = row && row->format.name == "NRRD", isNifti = row && row->format.name == "NIfTI";
  if (!isNrrd && !isNifti) failInput(path, "labels are written as .nrrd, .seg.nrrd, .nii or .nii.gz");
  Volume v = volumeOf(labels, progress);
  checkWhole(v, path);
  LabelExtras extras = extrasOf(labels);
  auto write = isNrrd ? writeNrrdWith : writeNiftiWith;
  writeAtomically(path, [&](const Path& temporary) { write(v, temporary, extras, progress); });
  progress.report(1.0, "Wrote " + path.filename().string());
}

}  // namespace velum::io
