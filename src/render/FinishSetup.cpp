#include "render/FinishSetup.h"

#include <algorithm>
#include <cmath>

#include "render/FrameData.h"
#include "render/RenderPicture.h"
#include "shared/instance.h"

namespace velum::render {

namespace {

constexpr double kRows = 1000.0;        // of the picture whose pixels lengths are in
constexpr double kFinestStrokes = 3.0;  // pixels from one to the next
constexpr int kStrokeReach = 3 + 2;     // cells: of the smoothing, and of what is looked at in a cell and around it

double pixelsOf(double length, const Frame& frame) { return length * frame.pictureSize.y / kRows; }

/// Half of a line lies on either side of an edge; nearer than the next pixel nothing is known.
double halfLine(const Frame& frame) { return 0.5 * pixelsOf(frame.scene.finish.contourWidth, frame); }

int reachOf(const Frame& frame) { return std::max(1, int(std::lround(halfLine(frame)))); }

/// As far from an edge as the widest lines of models are looked for.
double strongReach(const Frame& frame) {
  return double(shared::kStrongLine * shared::kLineCircle) * pixelsOf(frame.scene.finish.contourWidth, frame);
}

double strokePixels(const Frame& frame) {
  return std::max(kFinestStrokes, pixelsOf(frame.scene.finish.hatchWidth, frame));
}

/// As far as is looked around a pixel of a model, to see how open it lies (openness.comp).
int openMargin(const Frame& frame) {
  const scene::Lighting& light = frame.scene.lighting;
  if (!isModelDrawn(frame.scene) || !light.shaded) return 0;
  constexpr int kNeighbours = 2 * shared::kOpenStep + 2;  // whose openness and normals count
  return kNeighbours + (light.occlusion > 0 ? int(std::ceil(shared::kOpenReach * float(frame.pictureSize.y))) : 0);
}

}  // namespace

bool needsSamples(const scene::Finish& finish) {
  return finish.contours > 0 || finish.litSphere > 0 || finish.hatching > 0;
}

shared::FinishParams makeFinishParams(const Frame& frame, int sphereRows, scene::DepthSteps steps) {
  const scene::Finish& finish = frame.scene.finish;
  shared::FinishParams params{};
  params.contourColor = glm::vec4(finish.contourColor, 0.0f);
  params.paperColor = glm::vec4(finish.paperColor, 0.0f);
  params.contours = float(finish.contours);
  params.reach = reachOf(frame);
  params.contourPixels = float(2.0 * halfLine(frame));
  params.creases = float(finish.contourCreases);
  params.steps = float(finish.contourSteps);
  params.structures = float(finish.contourStructures);
  params.litSphere = float(finish.litSphere);
  params.hatching = float(finish.hatching);
  params.strokePixels = float(strokePixels(frame));
  params.cellPixels = params.strokePixels * shared::kCellPeriods;
  params.paperGrain = float(finish.paperGrain);
  params.unitsPerPixel = float(kRows / frame.pictureSize.y);
  params.paperUnits = params.unitsPerPixel / float(finish.paperScale);
  params.sphereRows = std::max(1, sphereRows);
  params.stepLength = float(steps.least);
  params.deepStep = float(steps.deep);
  glm::vec2 first = glm::floor(glm::vec2(frame.windowOrigin) / params.cellPixels);
  glm::vec2 last = glm::floor(glm::vec2(frame.windowOrigin + frame.windowSize) / params.cellPixels);
  params.firstCellX = int(first.x);
  params.firstCellY = int(first.y);
  params.cellsX = int(last.x - first.x) + 1;
  params.cellsY = int(last.y - first.y) + 1;
  return params;
}

int lineMargin(const Frame& frame) {
  if (!isModelDrawn(frame.scene)) return frame.scene.finish.contours > 0 ? reachOf(frame) : 0;
  if (!needsSamples(frame.scene.finish)) return 0;
  return int(std::ceil(std::max(double(reachOf(frame)), strongReach(frame) + 1.0) +
                       pixelsOf(double(shared::kCalmReach), frame) + 1.0));
}

int windowMargin(const Frame& frame) {
  const scene::Finish& finish = frame.scene.finish;
  int margin = std::max(lineMargin(frame), openMargin(frame));
  if (finish.hatching > 0)
    margin = std::max(
        margin, int(std::ceil((kStrokeSteps + kStrokeReach) * strokePixels(frame) * double(shared::kCellPeriods))));
  return margin;
}

}  // namespace velum::render
