#include "render/passes/InstanceShading.h"

#include <algorithm>
#include <cmath>

#include "render/Renderer.h"
#include "render/WorkQueue.h"
#include "shared/bindings.h"

namespace velum::render {

namespace {

constexpr int kSoftwareShaded = 1 << 17;  // pixels at a time: some 20 ms
constexpr int kTaps = 7, kPreviewTaps = 3;
constexpr int kEdge = 8;  // of a group

shared::InstanceShade shadeOf(const FrameData& data, int sample, const InstanceShading::Views& views) {
  const scene::Scene& scene = data.frame.scene;
  scene::ModelBox box = scene::modelBox(scene.model);
  glm::dvec3 forward(data.params.forward), eye = glm::dvec3(glm::vec3(data.params.eye));
  double scale = angstromOf(data);
  glm::dvec3 low = box.low * scale + modelOrigin(data), high = box.high * scale + modelOrigin(data);
  double middle = glm::dot(0.5 * (low + high) - eye, forward);
  double half = 0.5 * glm::dot(glm::abs(forward), high - low);
  bool hasPaper = scene.finish.paper != scene::Paper::None;
  shared::InstanceShade values{};
  values.fogTop = glm::vec4(hasPaper ? scene.finish.paperColor : scene.background.top, 1.0f);
  values.fogBottom = glm::vec4(hasPaper ? scene.finish.paperColor : scene.background.bottom, 1.0f);
  values.fog = float(scene.lighting.fog);
  values.fogNear = float(std::max(0.0, middle - half));
  values.fogFar = float(middle + half);
  values.nearColors = float(scene.model.nearColors);
  values.radius = float(scene.lighting.occlusionRadius * glm::length(high - low));
  values.lightTexel = views.lightTexel;
  values.noise = float(std::fmod(0.6180339887498949 * sample, 1.0));
  values.occlusionTaps = data.frame.isPreview ? kPreviewTaps : kTaps;
  values.firstInstance = firstModelInstance(scene);
  values.firstType = std::uint32_t(data.structures.size());
  values.palette = static_cast<int>(scene.model.palette);
  values.hasLight = views.light ? 1 : 0;
  values.angstrom = float(scale);
  values.openShift = glm::ivec2(sample & 1, sample >> 1 & 1);
  return values;
}

/// The places of openness that pixels look at.
glm::ivec4 placesAbout(glm::ivec4 pixels, glm::ivec2 places) {
  glm::ivec2 from = glm::max(glm::ivec2(pixels) / shared::kOpenStep - 1, glm::ivec2(0));
  glm::ivec2 to = glm::min(glm::ivec2(pixels.x + pixels.z, pixels.y + pixels.w) / shared::kOpenStep + 2, places);
  return {from, glm::max(to - from, glm::ivec2(0))};
}

}  // namespace

void InstanceShading::compile() {
  if (!mOpenness) mOpenness = gpu::Program({"render/openness.comp"});
  if (!mShade) mShade = gpu::Program({"render/instances.comp"});
}

void InstanceShading::addSteps(const FrameData& data, int sample, Views views, InstanceDraw& draw, WorkQueue& queue) {
  glm::ivec2 size = data.frame.windowSize, places = (size + shared::kOpenStep - 1) / shared::kOpenStep;
  glm::ivec4 drawn = drawnRect(data);
  draw.add(queue, [this, &data, sample, views, places] {
    mParams.set(shadeOf(data, sample, views));
    if (!mOpen || glm::ivec2(mOpen.size()) != places)
      mOpen = gpu::Texture::make2d("openness", gpu::Format::Rgba32f, places);
  });
  // Openness first, all of it: a pixel looks at its neighbours'.
  if (data.frame.scene.lighting.shaded)
    addStrips(mOpenness, placesAbout(drawn, places), data.isSoftware, views, draw, queue);
  addStrips(mShade, drawn, data.isSoftware, views, draw, queue);
}

/// Strips of rows, each as much as a software driver has done before anybody notices.
void InstanceShading::addStrips(const gpu::Program& program, glm::ivec4 rect, bool isSoftware, Views views,
                                InstanceDraw& draw, WorkQueue& queue) {
  glm::ivec2 corner(rect), size(rect.z, rect.w);
  if (size.x == 0) return;
  int rows = isSoftware ? std::max(kSoftwareShaded / size.x, 1) : size.y;
  rows = (rows + kEdge - 1) / kEdge * kEdge;
  for (int first = 0; first < size.y; first += rows)
    draw.add(queue, [this, &program, corner, size, first, rows, views] {
      bind(views);
      if (&program == &mOpenness)
        mOpen.bindImage(shared::kOpenImage, gpu::Access::Write);
      else
        mSurfaces.bindImages();
      program.set(0, corner + glm::ivec2(0, first));
      gpu::dispatch(program, {(size.x + kEdge - 1) / kEdge, (std::min(rows, size.y - first) + kEdge - 1) / kEdge, 1});
      gpu::barrier();
    });
}

void InstanceShading::bind(const Views& views) const {
  const model::InstanceTarget& light = views.light ? *views.light : views.eye;
  views.eye.bindView(shared::kInstanceViewBinding);
  light.bindView(shared::kInstanceLightBinding);
  mParams.bind(shared::kInstanceShadeBinding);
  views.eye.bindOwners();
  views.eye.bindDepths(shared::kDepthUnit);
  light.bindDepths(shared::kShadowUnit);
  mOpen.bindSampler(shared::kOpenUnit);
}

}  // namespace velum::render
