#include "session/look/Look.h"

#include <fmt/format.h>

#include "core/Error.h"
#include "io/looks/TransferFile.h"
#include "scene/json/Json.h"
#include "session/document/Open.h"

namespace velum::session {

namespace {

/// Mean edge of a voxel; 1 where there is no volume.
double voxel(const scene::VolumeLayer& layer) {
  if (!layer.data) return 1.0;
  glm::dvec3 spacing = spacingOf(*layer.data);
  return (spacing.x + spacing.y + spacing.z) / 3.0;
}

scene::TransferFunction transferOf(io::TransferFile file, double voxel) {
  if (file.isGradientPerVoxel)
    for (auto& point : file.transfer.gradientOpacities) point.value /= voxel;
  return file.transfer;
}

}  // namespace

bool isLookFile(const std::filesystem::path& path) { return io::isTransferFile(path); }

std::vector<std::string> importLook(scene::Scene& scene, const std::filesystem::path& path) {
  io::TransferFile file = io::readTransferFile(path);
  std::vector<std::string> warnings = std::move(file.warnings);
  scene::TransferFunction transfer = transferOf(std::move(file), voxel(scene.volume));
  scene::TransferFunction& target = scene::currentTransfer(scene.volume);
  if (transfer.colors.empty()) transfer.colors = target.colors;
  target = std::move(transfer);
  scene.rayCast.mode = scene::RenderMode::Volume;
  return warnings;
}

std::vector<std::string> exportLook(const scene::Scene& scene, const std::filesystem::path& path) {
  auto losses = io::writeTransferFile(scene::currentTransfer(scene.volume), scene.lighting, voxel(scene.volume), path);
  if (scene.volume.channels.size() > 1)
    losses.push_back(fmt::format("the looks of {} other channels are left out", scene.volume.channels.size() - 1));
  if (scene.unit != LengthUnit::Millimetre)
    losses.push_back(fmt::format("lengths in it are in {}, which the file does not say", enumName(scene.unit)));
  return losses;
}

std::vector<std::string> convertLook(const std::filesystem::path& input, const std::filesystem::path& output) {
  scene::Scene scene;
  std::vector<std::string> losses;
  if (isLookFile(input)) {
    losses = importLook(scene, input);
  } else {
    auto text = readSceneText(input);
    if (!text)
      throw InputError(fmt::format("{}: neither a scene, a picture of ours nor a transfer function; name one of these",
                                   input.string()));
    try {
      scene = scene::fromJson(*text);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", input.string(), error.what()));
    }
    // Without its data nobody can tell whether the scene mixes its channels: that it has looks for several says so.
    if (scene.volume.channels.size() > 1)
      scene.volume.transfer =
          scene.volume.channels[std::min(std::size_t(scene.volume.channel), scene.volume.channels.size() - 1)].transfer;
  }
  auto more = exportLook(scene, output);
  losses.insert(losses.end(), more.begin(), more.end());
  return losses;
}

}  // namespace velum::session
