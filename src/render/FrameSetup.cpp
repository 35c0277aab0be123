#include "render/FrameSetup.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/Vectors.h"
#include "scene/Project.h"

namespace velum::render {

namespace {

glm::vec4 homogeneous(glm::dvec3 v, double w = 0.0) { return glm::vec4(glm::vec3(v), float(w)); }

/// A projection with the rays of rayThrough(): rows run downwards, depth covers the scene's sphere.
glm::dmat4 clipFromScene(const Frame& frame, const FrameGrid& grid, const scene::CameraBasis& basis, glm::dvec3 eye,
                         glm::dvec2 shift) {
  const auto& camera = frame.scene.camera;
  glm::dmat4 viewFromScene(1.0);
  for (int i = 0; i < 3; ++i) {
    viewFromScene[i][0] = basis.right[i];
    viewFromScene[i][1] = basis.up[i];
    viewFromScene[i][2] = basis.forward[i];
  }
  viewFromScene[3] =
      glm::dvec4(-glm::dot(basis.right, eye), -glm::dot(basis.up, eye), -glm::dot(basis.forward, eye), 1.0);
  double tall = scene::halfPictureHeight(camera), wide = tall * frame.pictureSize.x / frame.pictureSize.y;
  double reach = 4.0 * sceneRadius(grid) + glm::length(eye);
  double nearest = reach * 1e-4, farthest = 2.0 * reach;
  glm::dmat4 p(0.0);
  p[0][0] = 1.0 / wide;
  p[1][1] = -1.0 / tall;  // picture rows run downwards
  if (camera.projection == scene::Projection::Perspective) {
    p[2][2] = (farthest + nearest) / (farthest - nearest);
    p[2][3] = 1.0;
    p[3][2] = -2.0 * farthest * nearest / (farthest - nearest);
  } else {
    p[2][2] = 1.0 / farthest;
    p[3][3] = 1.0;
  }
  // The window out of the whole picture, moved by the sample's place in its pixel.
  glm::dvec2 whole(frame.pictureSize), origin(frame.windowOrigin), size(frame.windowSize);
  glm::dmat4 window(1.0);
  window[0][0] = whole.x / size.x;
  window[1][1] = whole.y / size.y;
  window[3][0] = (whole.x - 2.0 * (origin.x + shift.x)) / size.x - 1.0;
  window[3][1] = (whole.y - 2.0 * (origin.y + shift.y)) / size.y - 1.0;
  return window * p * viewFromScene;
}

}  // namespace

double sceneRadius(const FrameGrid& grid) {
  glm::dmat3 m(grid.worldFromTex);
  return 0.5 * (glm::length(m[0]) + glm::length(m[1]) + glm::length(m[2]));
}

EyeRays makeEyeRays(const scene::Camera& camera, double aspect, glm::dvec3 origin, double radius) {
  EyeRays rays;
  scene::CameraBasis basis = scene::cameraBasis(camera);
  double tall = scene::halfPictureHeight(camera);
  rays.right = basis.right * tall * aspect;
  rays.up = basis.up * tall;
  rays.forward = basis.forward;
  rays.isOrthographic = camera.projection == scene::Projection::Orthographic;
  rays.eye = camera.eye - origin;
  if (rays.isOrthographic) {
    // The picture plane stands in front of everything, wherever the eye is said to be.
    glm::dvec3 target = camera.target - origin;
    rays.eye = target - basis.forward * (glm::length(target) + 2.0 * radius);
  }
  return rays;
}

shared::FocusView makeFocusView(const scene::Scene& scene, const model::FocusRow& row, double aspect, glm::dvec3 origin,
                                double radius) {
  const auto& lock = row.focus->lock;
  double wide = lock ? lock->aspect : aspect;
  EyeRays rays = makeEyeRays(lock ? lock->camera : scene.camera, wide, origin, radius);
  shared::FocusView view{};
  view.eye = homogeneous(rays.eye);
  view.right = homogeneous(rays.right);
  view.up = homogeneous(rays.up);
  view.forward = homogeneous(rays.forward);
  view.size = {std::clamp(int(std::lround(shared::kFocusRows * wide)), 1, 16 * shared::kFocusRows), shared::kFocusRows};
  view.isOrthographic = rays.isOrthographic ? 1 : 0;
  view.cut = row.cut;
  view.guidesDepth = row.focus->guidesDepth ? 1 : 0;
  view.hasAperture = row.hasAperture ? 1 : 0;
  return view;
}

double diameterOf(const FrameGrid& grid) {
  glm::dmat3 m(grid.worldFromTex);
  double diameter = glm::length(glm::dvec3(glm::length(m[0]), glm::length(m[1]), glm::length(m[2])));
  return diameter > 0.0 ? diameter : 1.0;
}

glm::dvec3 sceneOrigin(const FrameGrid& grid) { return glm::dvec3(grid.worldFromTex * glm::dvec4(0.5, 0.5, 0.5, 1.0)); }

namespace {

/// The place of sample n in its pixel, from its middle. [R2]: a well-spread sequence for any count.
glm::dvec2 r2(int n) {
  auto wrapped = [n](double step) { return std::fmod(0.5 + step * n, 1.0) - 0.5; };
  return {wrapped(0.7548776662466927), wrapped(0.5698402909980532)};
}

/// The same for the samples of one picture: the first goes through the middle, and their mean lies there, so that
/// pictures of few samples are not displaced.
glm::dvec2 placeInPixel(int sample, int samples) {
  if (sample == 0) return glm::dvec2(0.0);
  glm::dvec2 sum(0.0);
  for (int n = 1; n < samples; ++n) sum += r2(n);
  return r2(sample) - sum / double(samples - 1);
}

}  // namespace

void setSample(shared::FrameParams& params, const Frame& frame, int sample) {
  glm::dvec2 shift = placeInPixel(sample, frame.scene.rayCast.samplesPerPixel);
  params.pictureSize = frame.pictureSize;
  params.subpixel = shift;
  params.noise = float(std::fmod(0.6180339887498949 * sample, 1.0));
  params.sampleIndex = sample;
  FrameGrid grid;
  grid.worldFromTex = glm::inverse(glm::dmat4(params.texFromScene));
  params.clipFromScene = glm::mat4(
      clipFromScene(frame, grid, scene::cameraBasis(frame.scene.camera), glm::dvec3(glm::vec3(params.eye)), shift));
}

glm::vec3 pointOnRay(const shared::FrameParams& params, glm::ivec2 pixel, float distance) {
  glm::vec2 at = glm::vec2(2, -2) * (glm::vec2(pixel) + 0.5f) / params.pictureSize + glm::vec2(-1, 1);
  glm::vec3 across = at.x * glm::vec3(params.right) + at.y * glm::vec3(params.up);
  glm::vec3 eye(params.eye), forward(params.forward);
  if (params.flags & shared::kFlagOrthographic) return eye + across + distance * forward;
  return eye + distance * glm::normalize(forward + across);
}

glm::ivec4 coveredRect(const shared::FrameParams& params, const Frame& frame) {
  return rectOfBox(params, frame, glm::vec3(0.0f), glm::vec3(1.0f));
}

glm::ivec4 rectOfBox(const shared::FrameParams& params, const Frame& frame, glm::vec3 boxLow, glm::vec3 boxHigh) {
  glm::mat4 sceneFromTex = glm::inverse(params.texFromScene);
  glm::vec3 eye(params.eye), forward(params.forward), right(params.right), up(params.up);
  glm::vec2 low(std::numeric_limits<float>::max()), high(std::numeric_limits<float>::lowest());
  for (int corner = 0; corner < 8; ++corner) {
    glm::vec3 share(corner & 1, corner >> 1 & 1, corner >> 2);
    glm::vec3 d = glm::vec3(sceneFromTex * glm::vec4(glm::mix(boxLow, boxHigh, share), 1)) - eye;
    float depth = glm::dot(d, forward);
    // A box around or behind the eye may show anywhere.
    if (!(depth > 1e-3f * glm::length(d))) return {0, 0, frame.windowSize};
    if (params.flags & shared::kFlagOrthographic) depth = 1;
    glm::vec2 at = glm::vec2(glm::dot(d, right) / glm::dot(right, right), glm::dot(d, up) / glm::dot(up, up)) / depth;
    glm::vec2 pixel = (at * glm::vec2(0.5f, -0.5f) + 0.5f) * params.pictureSize;
    low = glm::min(low, pixel);
    high = glm::max(high, pixel);
  }
  // Samples lie up to half a pixel aside, outlines are a pixel wide.
  glm::vec2 window(frame.windowOrigin), size(frame.windowSize);
  glm::ivec2 from(glm::clamp(glm::floor(low - window) - 2.0f, glm::vec2(0), size));
  glm::ivec2 to(glm::clamp(glm::ceil(high - window) + 2.0f, glm::vec2(0), size));
  return {from, glm::max(to - from, glm::ivec2(0))};
}

namespace {

/// Radius about the data of a cut that is everywhere; as their diameter is 1, nothing lies beyond it.
constexpr float kEverywhere = 1e9f;

void addMembrane(shared::CutData& data, const scene::Cut& cut, glm::ivec4 sheet) {
  const scene::Membrane& membrane = *cut.membrane;
  data.kind.w = membrane.use == scene::MembraneUse::Inlay ? shared::kMembraneInlay : shared::kMembraneClip;
  data.sheet = {glm::ivec3(sheet), static_cast<int>(membrane.look)};
  double falloff = membrane.falloff > 0 ? membrane.falloff : cut.size.z * 0.5;
  double above = std::clamp(1.0 + membrane.emphasis, 0.0, 1.0), below = std::clamp(1.0 - membrane.emphasis, 0.0, 1.0);
  if (cut.invert) std::swap(above, below);
  data.inlay = {float(std::clamp(membrane.inlayOpacity, 0.0, 1.0)), float(1.0 / std::max(falloff, 1e-9)), float(above),
                float(below)};
}

}  // namespace

std::vector<shared::CutData> makeCutData(const scene::Scene& scene, glm::dvec3 origin, const SheetPlans& sheets,
                                         double sheetScale) {
  std::vector<shared::CutData> out;
  bool opensGroup = true;  // no cut is there yet to which one could be joined
  for (const auto& cut : scene.cuts) {
    bool isInlay = scene::isInlay(cut);
    opensGroup = opensGroup || !cut.joined || isInlay;
    if (!cut.enabled) continue;
    glm::dmat4 sceneFromCut = scene::worldFromCut(cut);
    sceneFromCut[3] -= glm::dvec4(origin, 0.0);
    shared::CutData data{};
    data.localFromScene = glm::mat4(glm::inverse(sceneFromCut));
    glm::dvec3 half = solidEdges(cut.size) * 0.5;
    data.halfSize = homogeneous(half, cut.invert ? -1.0 : 1.0);
    int shape = static_cast<int>(cut.shape);
    if (cut.shape == scene::CutShape::Everywhere) {
      shape = shared::kCutSphere;
      data.localFromScene = glm::mat4(1.0f);
      data.halfSize = {glm::vec3(kEverywhere), cut.invert ? -1.0f : 1.0f};
    }
    bool isWalked = !scene::isMembrane(cut) && !shared::cutIsConvex(shape);
    data.kind = {shape, cut.face == scene::CutFace::Section ? 1 : 0, isWalked ? shared::kCutWalks : 0, 0};
    if (!opensGroup) data.kind.z |= shared::kCutJoined;
    opensGroup = isInlay;
    data.face = {float(cut.faceOpacity), float(sheetScale), 0, 0};
    if (scene::isMembrane(cut)) addMembrane(data, cut, sheets.at(cut.id));
    out.push_back(data);
  }
  return out;
}

std::vector<shared::StructureRow> makeStructureRows(const scene::LabelLayer& labels) {
  int largest = 0;
  for (const auto& s : labels.structures) largest = std::max(largest, s.id);
  constexpr glm::vec4 kPlain(1.0f, 0.0f, 0.0f, 0.0f);
  std::vector<shared::StructureRow> rows(std::size_t(largest) + 1, {glm::vec4(0.6f, 0.6f, 0.6f, 1.0f), kPlain});
  for (const auto& s : labels.structures)
    rows[std::size_t(s.id)] = {glm::vec4(s.color, s.visible ? float(s.opacity) : 0.0f),
                               glm::vec4(float(s.tint), s.showAs == scene::ShowAs::Solid ? 1.0f : 0.0f, 0.0f, 0.0f)};
  return rows;
}

}  // namespace velum::render
