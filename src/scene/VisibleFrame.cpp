#include "velum/scene/VisibleFrame.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "velum/scene/Presets.h"

namespace velum::scene {

namespace {

constexpr double kMostSamples = 2e6;
constexpr double kVisible = 0.08;  ///< opacity of a unit of distance: less is a veil
constexpr double kSpecks = 1e-3;   ///< of what shows, that may be outside of the picture
constexpr double kMargin = 1.08;

int strideFor(glm::ivec3 dims) {
  double count = double(dims.x) * double(dims.y) * double(dims.z);
  return std::max(1, int(std::ceil(std::cbrt(count / kMostSamples))));
}

/// Whether a value of the volume shows.
class Shows {
 public:
  Shows(const Scene& scene, const Volume& volume) : mScene(scene), mVolume(volume) {
    mChannels = mixesChannels(scene.volume) ? volume.channels : 1;
    mFirst = mixesChannels(scene.volume) ? 0 : std::clamp(scene.volume.channel, 0, volume.channels - 1);
    mTime = std::clamp(scene.volume.timeStep, 0, volume.timeSteps - 1);
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
      return look.visible && opacityAt(look.transfer.opacities, value) > kVisible;
    }
    if (mScene.rayCast.mode == RenderMode::Mip && layer.windowWidth > 0)
      return value > layer.windowLevel - 0.3 * layer.windowWidth;
    return layer.transfer.opacities.empty() || opacityAt(layer.transfer.opacities, value) > kVisible;
  }
  const Scene& mScene;
  const Volume& mVolume;
  int mChannels, mFirst, mTime;
};

/// Places, world, of every so manieth voxel that shows.
std::vector<glm::dvec3> shownPlaces(const Scene& scene) {
  std::vector<glm::dvec3> places;
  auto visit = [&](glm::ivec3 dims, const glm::dmat4& worldFromVoxel, auto&& shows) {
    int stride = strideFor(dims);
    glm::ivec3 p;
    for (p.z = std::min(stride / 2, dims.z - 1); p.z < dims.z; p.z += stride)
      for (p.y = std::min(stride / 2, dims.y - 1); p.y < dims.y; p.y += stride)
        for (p.x = std::min(stride / 2, dims.x - 1); p.x < dims.x; p.x += stride)
          if (shows(p)) places.emplace_back(worldFromVoxel * glm::dvec4(glm::dvec3(p), 1.0));
  };
  if (scene.volume.data) {
    Shows shows(scene, *scene.volume.data);
    visit(scene.volume.data->dims, scene.volume.data->worldFromVoxel, shows);
  }
  if (!scene.labels.data) return places;
  std::vector<bool> isHidden(65536, false);
  isHidden[0] = !scene.volume.data || scene.labels.unlabelled <= kVisible;
  for (const Structure& structure : scene.labels.structures)
    isHidden[std::size_t(structure.id)] = !structure.visible || structure.opacity <= kVisible;
  const LabelVolume& labels = *scene.labels.data;
  if (!scene.volume.data) {
    visit(labels.dims(), labels.worldFromVoxel(), [&](glm::ivec3 p) { return !isHidden[labels.at(p)]; });
    return places;
  }
  glm::dmat4 voxelFromWorld = glm::inverse(labels.worldFromVoxel());
  std::erase_if(places, [&](const glm::dvec3& place) {
    glm::ivec3 p(glm::round(glm::dvec3(voxelFromWorld * glm::dvec4(place, 1.0))));
    bool isInside = glm::all(glm::greaterThanEqual(p, glm::ivec3(0))) && glm::all(glm::lessThan(p, labels.dims()));
    return bool(isHidden[isInside ? labels.at(p) : 0]);
  });
  return places;
}

/// All but the outermost of some numbers, which are put into another order.
std::pair<double, double> trimmed(std::vector<double>& numbers) {
  auto spare = std::ptrdiff_t(double(numbers.size()) * kSpecks);
  auto low = numbers.begin() + spare, high = numbers.end() - 1 - spare;
  std::nth_element(numbers.begin(), low, numbers.end());
  double least = *low;
  std::nth_element(numbers.begin(), high, numbers.end());
  return {least, *high};
}

}  // namespace

Camera frameVisible(const Scene& scene, StandardView view, double aspect) {
  Camera camera = frameCamera(scene, view, aspect);
  bool isColor = scene.volume.data && scene.volume.data->isColor;
  bool isBox = isColor || isAllMaterial(scene.volume.transfer.preset);
  bool isAlone = scene.surfaces.empty() && !scene.model.data && !isBox;
  if (!isAlone || (!scene.volume.data && !scene.labels.data)) return camera;
  std::vector<glm::dvec3> places = shownPlaces(scene);
  if (places.size() < 50) return camera;
  // As the picture sees them: to the right, up, towards the eye.
  glm::dvec3 toEye = glm::normalize(camera.eye - camera.target), right = glm::normalize(glm::cross(camera.up, toEye)),
             up = glm::cross(toEye, right);
  glm::dmat3 seenFromWorld = glm::transpose(glm::dmat3(right, up, toEye));
  std::vector<double> across(places.size()), along(places.size()), depths(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    places[i] = seenFromWorld * places[i];
    across[i] = places[i].x, along[i] = places[i].y, depths[i] = places[i].z;
  }
  auto [left, rightmost] = trimmed(across);
  auto [bottom, top] = trimmed(along);
  auto [back, front] = trimmed(depths);
  glm::dvec3 middle(0.5 * (left + rightmost), 0.5 * (bottom + top), 0.5 * (back + front));
  double voxel = 0.0;
  glm::dmat4 m = scene.volume.data ? scene.volume.data->worldFromVoxel : scene.labels.data->worldFromVoxel();
  for (int axis = 0; axis < 3; ++axis) voxel = std::max(voxel, glm::length(glm::dvec3(m[axis])));
  // So far that all of them are inside of the pyramid that the eye sees.
  double tangent = std::tan(glm::radians(camera.fieldOfViewDeg) * 0.5);
  std::vector<double>& distances = across;
  for (std::size_t i = 0; i < places.size(); ++i) {
    glm::dvec3 off = places[i] - middle;
    double wide = std::max((std::abs(off.x) + voxel) / aspect, std::abs(off.y) + voxel);
    distances[i] = wide * kMargin / tangent + off.z;
  }
  double distance = trimmed(distances).second;
  camera.height = 2.0 * kMargin * std::max(0.5 * (top - bottom) + voxel, (0.5 * (rightmost - left) + voxel) / aspect);
  camera.target = glm::transpose(seenFromWorld) * middle;
  camera.eye = camera.target + toEye * distance;
  return camera;
}

}  // namespace velum::scene
