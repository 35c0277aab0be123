#include "Data.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "core/Parallel.h"
#include "io/phantoms/Sample.h"
#include "io/volumes/ReadVolume.h"
#include "scene/Presets.h"

namespace velum::bench {

namespace {

/// A box of n^3 voxels about the origin.
void setFrame(Volume& volume, glm::ivec3 dims, glm::dvec3 spacing) {
  volume.dims = dims;
  volume.worldFromVoxel = glm::dmat4(1.0);
  for (int axis = 0; axis < 3; ++axis) {
    volume.worldFromVoxel[axis][axis] = spacing[axis];
    volume.worldFromVoxel[3][axis] = -0.5 * spacing[axis] * (dims[axis] - 1);
  }
}

/// Trilinear interpolation between voxels, clamped to the edge.
template <class T>
double sampleAt(const T* voxels, glm::ivec3 dims, glm::dvec3 p) {
  p = glm::clamp(p, glm::dvec3(0.0), glm::dvec3(dims - 1));
  glm::ivec3 a(p), b = glm::min(a + 1, dims - 1);
  glm::dvec3 f = p - glm::dvec3(a);
  auto at = [&](int x, int y, int z) {
    return double(
        voxels[(std::size_t(z) * std::size_t(dims.y) + std::size_t(y)) * std::size_t(dims.x) + std::size_t(x)]);
  };
  auto row = [&](int y, int z) { return glm::mix(at(a.x, y, z), at(b.x, y, z), f.x); };
  return glm::mix(glm::mix(row(a.y, a.z), row(b.y, a.z), f.y), glm::mix(row(a.y, b.z), row(b.y, b.z), f.y), f.z);
}

Case makeCase(std::string key, std::string title, Volume volume, std::string_view preset, double aspect) {
  Case item{std::move(key), std::move(title), {}};
  item.scene.volume.data = Shared<Volume>(std::move(volume));
  scene::applyPreset(item.scene, preset);
  item.scene.camera = scene::frameCamera(item.scene, scene::StandardView::Anterior, aspect);
  return item;
}

/// Real data, where it is at hand.
void addRealCase(std::vector<Case>& cases, const std::filesystem::path& path, std::string key, std::string title,
                 std::string_view preset, int n, double aspect) {
  if (!std::filesystem::exists(path)) return;
  Progress progress;
  Volume volume = io::readVolume({path.string()}, progress);
  cases.push_back(makeCase(std::move(key), std::move(title), resample(volume, glm::ivec3(n)), preset, aspect));
}

}  // namespace

gpu::Context& sharedContext() {
  static std::unique_ptr<gpu::Context> context = gpu::Context::create(gpu::ContextKind::Auto);
  context->makeCurrent();
  return *context;
}

Volume resample(const Volume& from, glm::ivec3 dims) {
  Volume to = from;
  to.channels = 1;
  to.timeSteps = 1;
  setFrame(to, dims, spacingOf(from) * glm::dvec3(from.dims) / glm::dvec3(dims));
  if (from.dims == to.dims && from.channels == 1 && from.timeSteps == 1) return to;
  to.voxels = Bytes(timeStepBytes(to));
  visitSamples(from, [&](auto* voxels) {
    using T = std::remove_cv_t<std::remove_pointer_t<decltype(voxels)>>;
    auto* out = reinterpret_cast<T*>(to.voxels.data());
    glm::dvec3 scale = glm::dvec3(from.dims) / glm::dvec3(dims);
    parallelFor(0, dims.z, [&](int z) {
      for (int y = 0; y < dims.y; ++y)
        for (int x = 0; x < dims.x; ++x) {
          double value = sampleAt(voxels, from.dims, (glm::dvec3(x, y, z) + 0.5) * scale - 0.5);
          if constexpr (std::is_integral_v<T>) value = std::round(value);
          out[(std::size_t(z) * std::size_t(dims.y) + std::size_t(y)) * std::size_t(dims.x) + std::size_t(x)] =
              T(value);
        }
    });
  });
  computeRange(to);
  return to;
}

Volume makePhantom(std::string_view name, glm::ivec3 dims) {
  Progress progress;
  int longest = std::max(dims.x, std::max(dims.y, dims.z));
  return resample(io::makeSample(name, longest, progress).volume, dims);
}

Volume makeCube(std::string_view phantom, int n) { return makePhantom(phantom, glm::ivec3(n)); }

Volume makeShells(int n) {
  Volume volume;
  volume.type = SampleType::UInt8;
  setFrame(volume, glm::ivec3(n), glm::dvec3(240.0 / n));
  volume.name = "shells";
  volume.range = {0.0, 255.0};
  volume.voxels = Bytes(std::size_t(n) * std::size_t(n) * std::size_t(n));
  // The gyroid's waves are products of waves along single axes, so tables replace nearly all of the work.
  std::vector<float> at(static_cast<std::size_t>(n)), sine(at.size()), cosine(at.size());
  for (int i = 0; i < n; ++i) {
    float x = 2.0f * (float(i) + 0.5f) / float(n) - 1.0f;
    at[std::size_t(i)] = x;
    sine[std::size_t(i)] = std::sin(24.0f * x);
    cosine[std::size_t(i)] = std::cos(24.0f * x);
  }
  auto* out = reinterpret_cast<std::uint8_t*>(volume.voxels.data());
  parallelFor(0, n, [&](int iz) {
    auto z = std::size_t(iz);
    for (std::size_t y = 0; y < at.size(); ++y)
      for (std::size_t x = 0; x < at.size(); ++x) {
        float gyroid = sine[x] * cosine[y] + sine[y] * cosine[z] + sine[z] * cosine[x];
        float r = std::sqrt(at[x] * at[x] + at[y] * at[y] + at[z] * at[z]) + 0.015f * gyroid;
        auto band = [&](float from, float to) {
          float edge = std::min(r - from, to - r) * 40.0f;
          return std::clamp(edge + 0.5f, 0.0f, 1.0f);
        };
        float inside = std::clamp(gyroid * 2.0f, 0.0f, 1.0f) * band(-1.0f, 0.55f);
        float value = std::max({80.0f * band(-1.0f, 0.92f), 230.0f * band(0.66f, 0.76f), 180.0f * inside});
        out[(z * at.size() + y) * at.size() + x] = std::uint8_t(value);
      }
  });
  return volume;
}

scene::Scene makeShellScene(const Shared<Volume>& volume, Opacity opacity, double aspect) {
  scene::Scene scene;
  scene.volume.data = volume;
  auto& transfer = scene.volume.transfer;
  transfer.colors = {{40, {0.90f, 0.70f, 0.58f}}, {100, {0.74f, 0.32f, 0.26f}}, {200, {0.96f, 0.91f, 0.80f}}};
  switch (opacity) {
    case Opacity::Opaque:
      transfer.opacities = {{120, 0}, {170, 0.9}, {255, 0.95}};
      break;
    case Opacity::SkinOverBone:
      transfer.opacities = {{30, 0}, {60, 0.02}, {90, 0.008}, {120, 0.008}, {190, 0.6}, {255, 0.9}};
      break;
    case Opacity::Translucent:
      transfer.opacities = {{30, 0}, {60, 0.002}, {120, 0.002}, {200, 0.006}, {255, 0.006}};
      break;
  }
  scene.volume.windowLevel = 128;
  scene.volume.windowWidth = 256;
  scene.rayCast.samplesPerPixel = 1;
  scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, aspect);
  return scene;
}

std::vector<Case> makeCases(int n, double aspect, bool withRealData) {
  std::vector<Case> cases;
  Volume torso = makeCube("torso", n);
  cases.push_back(makeCase("bone", "opaque bone (trunk phantom)", torso, "ct-bone", aspect));
  cases.push_back(makeCase("skin-bone", "skin over bone (trunk phantom)", torso, "ct-skin-bone", aspect));
  cases.push_back(makeCase("vessels", "thin vessels (phantom)", makeCube("vessels", n), "angiography", aspect));
  if (!withRealData) return cases;
  addRealCase(cases, "/usr/share/doc/invesalius-examples/examples/Cranium.inv3", "cranium", "opaque bone (CT head)",
              "ct-bone", n, aspect);
  if (const char* folder = std::getenv("VELUM_TEST_DATA"))
    addRealCase(cases, std::filesystem::path(folder) / "volumes/xa_aneurism.vti", "aneurism",
                "thin vessels (X-ray angiography)", "angiography", n, aspect);
  return cases;
}

scene::Scene plain(scene::Scene scene) {
  scene.lighting.shadow = 0;
  scene.lighting.occlusion = 0;
  scene.lighting.keyDirection = {0, 0, 1};
  scene.rayCast.jitter = false;
  scene.rayCast.samplesPerPixel = 1;
  scene.background = {glm::vec3(0.0f), glm::vec3(0.0f), false};
  return scene;
}

scene::Camera turned(scene::Camera camera, int i, int n) {
  double angle = 2.0 * 3.14159265358979 * (i + 0.06) / n;
  glm::dvec3 v = camera.eye - camera.target;
  double c = std::cos(angle), s = std::sin(angle);
  camera.eye = camera.target + glm::dvec3(c * v.x - s * v.y, s * v.x + c * v.y, v.z);
  return camera;
}

}  // namespace velum::bench
