#include "render/passes/InstanceViews.h"

#include <algorithm>
#include <cmath>

#include "model/InstanceRows.h"
#include "scene/ModelLooks.h"
#include "scene/Shown.h"

namespace velum::render {

namespace {

constexpr int kLeastLightEdge = 128, kWholeLightEdge = 512, kMostLightEdge = 1024;  // pixels of the light's view
constexpr float kLightDetail = 2.0f;                                                // shadows are soft
constexpr float kPreviewDetail = 3.0f;
constexpr float kLargeRadius = 10.0f;  // pixels: see docs/PERFORMANCE.md

/// Pixels along each edge of the light's view: about as many as a small picture has; half as many as a large one, as
/// shadows are soft and the view's balls take most of the time of a picture.
int lightEdge(const Frame& frame) {
  int longest = std::max(frame.pictureSize.x, frame.pictureSize.y), edge = kLeastLightEdge;
  while (edge < kWholeLightEdge && edge < longest) edge *= 2;
  return std::max(edge, std::min(longest / 2, kMostLightEdge));
}

}  // namespace

shared::InstanceView eyeViewOf(const FrameData& data, int sample) {
  const Frame& frame = data.frame;
  const scene::ModelLayer& model = frame.scene.model;
  shared::FrameParams params = data.params;
  setSample(params, frame, sample);
  scene::CopyGrid copies = scene::copyGrid(model);
  shared::InstanceView view{};
  view.eye = params.eye;
  view.right = params.right;
  view.up = params.up;
  view.forward = params.forward;
  view.pictureSize = params.pictureSize;
  view.shift = glm::vec2(frame.windowOrigin) + 0.5f + params.subpixel;
  double scale = angstromOf(data);
  view.copyStep = glm::vec4(glm::vec3(copies.step * scale), 0.0f);
  glm::dvec3 low = glm::dvec3(model.data->low) * scale, high = glm::dvec3(model.data->high) * scale;
  // Balls of coarse levels reach a little beyond the spheres of the atoms.
  view.copySphere =
      glm::vec4(glm::vec3(0.5 * (low + high) + modelOrigin(data)), 0.55f * float(glm::length(high - low)));
  view.copiesX = copies.counts.x;
  view.copiesY = copies.counts.y;
  view.copiesZ = copies.counts.z;
  view.copies = view.allCopies = scene::copyCount(model);
  view.firstWhole = shared::kNoInstance;
  view.instanceCount = int(model.data->instances.size());
  view.cutCount = int(data.cuts.size());
  view.isOrthographic = (params.flags & shared::kFlagOrthographic) ? 1 : 0;
  view.detail = float(scene::shapeDetail(frame.scene)) * (frame.isPreview ? kPreviewDetail : 1.0f);
  view.largeRadius = kLargeRadius;
  view.wholeInstances = model::wholeInstanceBits(frame.scene);
  return view;
}

shared::InstanceView lightViewOf(const FrameData& data, const shared::InstanceView& eye) {
  scene::ModelBox box = scene::modelBox(data.frame.scene.model);
  double scale = angstromOf(data);
  glm::dvec3 low = box.low * scale + modelOrigin(data), high = box.high * scale + modelOrigin(data);
  glm::dvec3 middle = 0.5 * (low + high);
  double radius = 0.5 * glm::length(high - low);
  glm::dvec3 forward(eye.forward), towards = glm::dvec3(glm::vec3(eye.eye));
  double depth = std::max(glm::dot(middle - towards, forward), 0.0);
  double shown = std::max(glm::length(glm::dvec3(eye.right)), glm::length(glm::dvec3(eye.up))) *
                 (eye.isOrthographic ? 1.0 : std::max(depth, 0.25 * radius)) * 1.4;
  if (shown < radius) middle = towards + forward * depth;
  double reach = std::min(radius, shown);
  shared::InstanceView view = eye;
  glm::dvec3 along = -glm::dvec3(data.params.keyLight);
  glm::dvec3 helper = std::abs(along.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
  glm::dvec3 right = glm::normalize(glm::cross(along, helper)), up = glm::cross(right, along);
  view.eye = glm::vec4(glm::vec3(middle - along * (2.0 * radius)), 0.0f);
  view.right = glm::vec4(glm::vec3(right * reach), 0.0f);
  view.up = glm::vec4(glm::vec3(up * reach), 0.0f);
  view.forward = glm::vec4(glm::vec3(along), 0.0f);
  view.pictureSize = glm::vec2(float(lightEdge(data.frame)));
  view.shift = glm::vec2(0.5f);
  view.isOrthographic = 1;
  view.detail = std::max(kLightDetail, view.detail);
  return view;
}

}  // namespace velum::render
