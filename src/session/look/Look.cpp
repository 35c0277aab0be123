#include "velum/session/look/Look.h"

#include <fmt/format.h>

#include "velum/core/Error.h"
#include "velum/io/looks/TransferFile.h"
#include "velum/scene/json/Json.h"
#include "velum/session/document/Open.h"

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

void importLook(scene::Scene& scene, const std::filesystem::path& path) {
  scene::TransferFunction transfer = transferOf(io::readTransferFile(path), voxel(scene.volume));
  scene::TransferFunction& target = scene::currentTransfer(scene.volume);
  if (transfer.colors.empty()) transfer.colors = target.colors;
  target = std::move(transfer);
  scene.rayCast.mode = scene::RenderMode::Volume;
}

void exportLook(const scene::Scene& scene, const std::filesystem::path& path) {
  io::writeTransferFile(scene::currentTransfer(scene.volume), scene.lighting, voxel(scene.volume), path);
}

void convertLook(const std::filesystem::path& input, const std::filesystem::path& output) {
  scene::Scene scene;
  if (isLookFile(input)) {
    importLook(scene, input);
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
  exportLook(scene, output);
}

}  // namespace velum::session
