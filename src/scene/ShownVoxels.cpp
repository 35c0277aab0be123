#include "scene/ShownVoxels.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/Scene.h"
#include "scene/Shown.h"

namespace velum::scene {

namespace {

/// Whether a value of the volume shows.
class Shows {
 public:
  Shows(const Scene& scene, const Volume& volume, double veil) : mScene(scene), mVolume(volume), mVeil(veil) {
    mChannels = mixesChannels(scene.volume) ? volume.channels : 1;
    mFirst = mixesChannels(scene.volume) ? 0 : shownChannel(scene.volume);
    mTime = shownTimeStep(scene.volume);
  }
  bool operator()(glm::ivec3 voxel) const {
    for (int channel = mFirst; channel < mFirst + mChannels; ++channel)
      if (isShown(valueAt(mVolume, voxel, channel, mTime), channel)) return true;
    return false;
  }

 private:
  bool isShown(double value, int channel) const {
    const VolumeLayer& layer = mScene.volume;
    if (mScene.rayCast.mode == RenderMode::Iso) return value >= mScene.rayCast.isoValue;
    if (mChannels > 1 || mixesChannels(layer)) {
      const ChannelLook& look = layer.channels[std::size_t(channel)];
      return look.visible && opacityAt(look.transfer.opacities, value) > mVeil;
    }
    if (mScene.rayCast.mode == RenderMode::Mip && layer.windowWidth > 0)
      return value > layer.windowLevel - 0.3 * layer.windowWidth;
    return layer.transfer.opacities.empty() || opacityAt(layer.transfer.opacities, value) > mVeil;
  }
  const Scene& mScene;
  const Volume& mVolume;
  double mVeil;
  int mChannels, mFirst, mTime;
};

/// Of each id how its structure shows: as its values do, not at all, or whatever its values.
enum class Way : std::uint8_t { ByValues, Never, Always };
std::vector<Way> waysOfIds(const Scene& scene, double veil) {
  std::vector<Way> ways(65536, Way::ByValues);
  if (!scene.volume.data || scene.labels.unlabelled <= veil) ways[0] = Way::Never;
  for (const Structure& structure : scene.labels.structures) {
    bool isSolid = !scene.volume.data || structure.showAs == ShowAs::Solid;
    bool isHidden = !structure.visible || structure.opacity <= veil;
    ways[std::size_t(structure.id)] = isHidden ? Way::Never : isSolid ? Way::Always : Way::ByValues;
  }
  return ways;
}

/// Every so manieth voxel of a grid, from the middle of the first block on. @param shows  (voxel of the whole grid)
template <class IsShown>
ShownVoxels everyManieth(glm::ivec3 dims, const glm::dmat4& worldFromVoxel, double mostSamples, IsShown shows) {
  double count = double(dims.x) * double(dims.y) * double(dims.z);
  int stride = std::max(1, int(std::ceil(std::cbrt(count / mostSamples))));
  glm::ivec3 first = glm::min(glm::ivec3(stride / 2), dims - 1);
  ShownVoxels out;
  out.dims = (dims - 1 - first) / stride + 1;
  out.worldFromVoxel = glm::scale(glm::translate(worldFromVoxel, glm::dvec3(first)), glm::dvec3(stride));
  out.shown.reserve(std::size_t(out.dims.x) * std::size_t(out.dims.y) * std::size_t(out.dims.z));
  glm::ivec3 p;
  for (p.z = first.z; p.z < dims.z; p.z += stride)
    for (p.y = first.y; p.y < dims.y; p.y += stride)
      for (p.x = first.x; p.x < dims.x; p.x += stride) out.shown.push_back(shows(p) ? 1 : 0);
  return out;
}

}  // namespace

ShownVoxels shownVoxels(const Scene& scene, double mostSamples, double veil) {
  const auto& volume = scene.volume.data;
  const auto& labels = scene.labels.data;
  if (!volume && !labels) return {};
  std::vector<Way> ways = waysOfIds(scene, veil);
  if (!volume)
    return everyManieth(labels->dims(), labels->worldFromVoxel(), mostSamples,
                        [&](glm::ivec3 p) { return ways[labels->at(p)] != Way::Never; });
  Shows shows(scene, *volume, veil);
  if (!labels) return everyManieth(volume->dims, volume->worldFromVoxel, mostSamples, shows);
  glm::dmat4 labelFromVoxel = glm::inverse(labels->worldFromVoxel()) * volume->worldFromVoxel;
  return everyManieth(volume->dims, volume->worldFromVoxel, mostSamples, [&](glm::ivec3 voxel) {
    glm::ivec3 p(glm::round(glm::dvec3(labelFromVoxel * glm::dvec4(glm::dvec3(voxel), 1.0))));
    bool isInside = glm::all(glm::greaterThanEqual(p, glm::ivec3(0))) && glm::all(glm::lessThan(p, labels->dims()));
    Way way = ways[isInside ? labels->at(p) : 0];
    return way == Way::Always || (way == Way::ByValues && shows(voxel));
  });
}

}  // namespace velum::scene
