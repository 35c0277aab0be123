#include "session/picture/PresetPictures.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/Parallel.h"
#include "scene/Presets.h"
#include "session/picture/SmallPictures.h"

namespace velum::session {

Volume reduceVolume(const Volume& volume, int channel, int timeStep, int mostAlong, const Progress& progress) {
  int longest = std::max(volume.dims.x, std::max(volume.dims.y, volume.dims.z));
  glm::ivec3 factor(std::max(1, (longest + mostAlong - 1) / mostAlong));
  // A slab keeps the few planes that it has.
  for (int axis = 0; axis < 3; ++axis) factor[axis] = std::min(factor[axis], std::max(1, volume.dims[axis] / 8));
  // The same place in the world: a small voxel lies in the middle of those that it stands for.
  Volume out;
  out.dims = (volume.dims + factor - 1) / factor;
  out.type = SampleType::Float32;
  out.range = volume.range;
  out.unit = volume.unit;
  out.modality = volume.modality;
  out.isSpacingKnown = volume.isSpacingKnown;
  out.isOrientationKnown = volume.isOrientationKnown;
  glm::dmat4 wholeFromSmall(1.0);
  for (int axis = 0; axis < 3; ++axis) {
    wholeFromSmall[axis][axis] = factor[axis];
    wholeFromSmall[3][axis] = 0.5 * (factor[axis] - 1);
  }
  out.worldFromVoxel = volume.worldFromVoxel * wholeFromSmall;
  out.voxels.resize(timeStepBytes(out));
  // Each is their mean, row by row.
  auto* target = reinterpret_cast<float*>(out.voxels.data());
  auto stride = std::size_t(volume.channels);
  std::size_t start = std::size_t(timeStep) * voxelCount(volume) * stride + std::size_t(channel);
  visitSamples(volume, [&](auto* samples) {
    parallelFor(0, out.dims.z * out.dims.y, [&](int job) {
      if (progress.isCancelled()) return;
      glm::ivec3 first(0, job % out.dims.y * factor.y, job / out.dims.y * factor.z);
      glm::ivec3 end = glm::min(first + factor, volume.dims);
      for (int x = 0; x < out.dims.x; ++x) {
        double sum = 0;
        int count = 0;
        for (int c = first.z; c < end.z; ++c)
          for (int b = first.y; b < end.y; ++b)
            for (int a = x * factor.x; a < std::min((x + 1) * factor.x, volume.dims.x); ++a) {
              std::size_t index =
                  (std::size_t(c) * std::size_t(volume.dims.y) + std::size_t(b)) * std::size_t(volume.dims.x) +
                  std::size_t(a);
              double raw = double(samples[start + index * stride]);
              if (std::isfinite(raw)) sum += raw, ++count;
            }
        double value = count ? sum / count * volume.scale + volume.offset : volume.range.x;
        target[std::size_t(job) * std::size_t(out.dims.x) + std::size_t(x)] = float(value);
      }
    });
  });
  progress.throwIfCancelled();
  return out;
}

namespace {

/// The part of a volume whose opacity counts, without voxels; all of it where nothing is visible.
Volume visibleBox(const Volume& volume, const std::vector<scene::OpacityPoint>& opacities) {
  constexpr double kVisible = 0.08;
  glm::ivec3 low = volume.dims, high(-1), p(0);
  for (p.z = 0; p.z < volume.dims.z; ++p.z)
    for (p.y = 0; p.y < volume.dims.y; ++p.y)
      for (p.x = 0; p.x < volume.dims.x; ++p.x)
        if (scene::opacityAt(opacities, valueAt(volume, p)) > kVisible)
          low = glm::min(low, p), high = glm::max(high, p);
  if (high.x < 0) low = glm::ivec3(0), high = volume.dims - 1;
  Volume box;
  box.dims = high - low + 1;
  box.worldFromVoxel = volume.worldFromVoxel;
  box.worldFromVoxel[3] = volume.worldFromVoxel * glm::dvec4(glm::dvec3(low), 1.0);
  return box;
}

}  // namespace

scene::Scene presetScene(const scene::Scene& scene, const Shared<Volume>& small, const std::string& preset,
                         double aspect) {
  scene::Scene fitted;
  fitted.volume = scene.volume;
  fitted.background = scene.background;
  scene::applyPreset(fitted, preset);
  scene::Scene shown = smallScene(fitted, small);
  shown.rayCast.samplesPerPixel = 1;
  // The box of what is visible fills the picture; a flat one does so better from aside.
  scene::Scene box;
  box.volume.data = Shared<Volume>(visibleBox(*small, shown.volume.transfer.opacities));
  scene::Bounds bounds = scene::computeBounds(box);
  glm::dvec3 edges = bounds.max - bounds.min;
  bool isFlat = edges.z < 0.5 * edges.x;
  shown.camera = scene::frameCamera(box, isFlat ? scene::StandardView::Oblique : scene::defaultView(shown), aspect);
  return shown;
}

void drawPresetPictures(const scene::Scene& scene, const std::vector<std::string>& presets, glm::ivec2 size,
                        const std::function<void(const std::string&, const Image&)>& done, Progress& progress) {
  Shared<Volume> small = smallVolume(scene.volume, progress);
  if (!small) return;
  auto sceneOf = [&](const std::string& preset) { return presetScene(scene, small, preset, double(size.x) / size.y); };
  drawSmallPictures(presets, size, sceneOf, done, progress);
}

}  // namespace velum::session
