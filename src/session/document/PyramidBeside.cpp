#include "session/document/PyramidBeside.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "core/Error.h"
#include "core/Memory.h"
#include "io/kinds/FileKind.h"
#include "io/stores/OpenStore.h"
#include "io/stores/WriteStore.h"
#include "io/volumes/OpenSource.h"
#include "io/volumes/ReadLevel.h"

namespace velum::session {

namespace fs = std::filesystem;

namespace {

constexpr double kBytesPerSecond = 40e6;  ///< of samples of 16 bits: two cores, a local disk, a window that is used
constexpr double kOfCoarser = 8.0 / 7.0;  ///< all levels together, in terms of the finest
constexpr double kLeastPacked = 0.25;     ///< of that, which hardly any volume goes below
constexpr double kUnasked = 0.125;        ///< of the machine's memory, that a volume takes without being asked about
constexpr double kGiB = double(1u << 30);

fs::path besidePath(const fs::path& file) { return file.parent_path() / (file.stem().string() + ".ome.zarr"); }

std::string obstacleTo(const PyramidBeside& plan) {
  fs::path folder = plan.path.parent_path().empty() ? fs::path(".") : plan.path.parent_path();
  if (::access(folder.c_str(), W_OK) != 0)
    return fmt::format("{}: nothing can be written there: {}", folder.string(), std::strerror(errno));
  if (!plan.isBegun && plan.freeBytes < kLeastPacked * plan.diskBytes)
    return fmt::format("{}: {:.1f} GiB are free; the pyramid may take up to {:.1f} GiB", folder.string(),
                       plan.freeBytes / kGiB, plan.diskBytes / kGiB);
  try {
    io::expectStoreWritable(plan.path);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

/// True for a whole store of voxels of the same number and type.
bool isPyramidOf(const fs::path& store, const VoxelSource& file) {
  if (!io::isStore(store) || io::isUnfinished(store)) return false;
  try {
    auto image = io::openImage(store, "");
    return image->levels().front().dims == file.levels().front().dims && image->head().type == file.head().type &&
           image->head().channels == file.head().channels && image->head().timeSteps == file.head().timeSteps;
  } catch (const InputError&) {
    return false;
  }
}

std::unique_ptr<VoxelSource> openOneLevel(const scene::Source& source) {
  std::error_code error;
  if (!fs::is_regular_file(source.path, error) || io::isStore(source.path)) return nullptr;
  if (io::kindOf(source) != io::FileKind::Volume) return nullptr;
  auto opened = io::openSource(source);
  return opened && opened->levels().size() == 1 ? std::move(opened) : nullptr;
}

}  // namespace

std::optional<PyramidBeside> pyramidBeside(const scene::Source& source, bool isAsked) {
  auto file = openOneLevel(source);
  if (!file) return std::nullopt;
  PyramidBeside plan;
  plan.sampleBytes = levelBytes(*file, 0);
  if (!isAsked && plan.sampleBytes <= io::wholeBudget()) return std::nullopt;
  plan.path = besidePath(source.path);
  plan.diskBytes = plan.sampleBytes * kOfCoarser;
  plan.seconds = plan.sampleBytes / kBytesPerSecond;
  plan.fitsMemory = plan.sampleBytes <= machineBytes() / 2;
  std::error_code error;
  fs::path folder = plan.path.parent_path().empty() ? fs::path(".") : plan.path.parent_path();
  if (auto room = fs::space(folder, error); !error) plan.freeBytes = double(room.available);
  plan.isBegun = io::isUnfinished(plan.path);
  plan.isThere = isPyramidOf(plan.path, *file);
  if (!plan.isThere) plan.obstacle = obstacleTo(plan);
  return plan;
}

bool isTooLarge(const scene::Source& source) {
  std::error_code error;
  double most = std::max(io::wholeBudget(), machineBytes() * kUnasked);
  bool mayBeLarge = double(fs::file_size(source.path, error)) > most;
  if (error || !mayBeLarge) return false;
  auto file = openOneLevel(source);
  return file && levelBytes(*file, 0) > most;
}

void makePyramidBeside(const scene::Source& source, const fs::path& to, Progress& progress) {
  auto file = openOneLevel(source);
  if (!file) throw InputError(fmt::format("{}: cannot be read piece by piece", source.path));
  io::writeStore(*file, to, {}, progress);
}

std::vector<std::string> levelLines(const scene::Source& source) {
  std::vector<std::string> lines;
  auto pyramid = io::openPyramid(source);
  for (std::size_t i = 0; pyramid && i < pyramid->levels().size(); ++i) {
    glm::ivec3 dims = pyramid->levels()[i].dims;
    double bytes = levelBytes(*pyramid, int(i));
    bool isLarge = bytes >= kGiB;
    lines.push_back(fmt::format("{} x {} x {}, {:.1f} {}", dims.x, dims.y, dims.z,
                                bytes / (isLarge ? kGiB : kGiB / 1024), isLarge ? "GiB" : "MiB"));
  }
  return lines;
}

scene::Source withPyramid(const scene::Source& source, const fs::path& pyramid) {
  scene::Source out;
  out.path = pyramid.string();
  out.spacing = source.spacing;
  return out;
}

}  // namespace velum::session
