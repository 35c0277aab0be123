#pragma once
#include "render/FrameSetup.h"
#include "shared/finish.h"

namespace velum::render {

/// Number of steps in which the phases of strokes spread, one cell a step.
constexpr int kStrokeSteps = 12;

/// True when the finish needs to know what each sample of the picture shows.
bool needsSamples(const scene::Finish& finish);

/// How many pixels around what is seen its lines go, and what they depend on.
int lineMargin(const Frame& frame);

/// Jumps of depth that have a line, scene frame: the least of them, and those of models that have a strong one.
struct DepthSteps {
  double least = 0.0;
  double deep = 0.0;
};

/// The parameters of a frame's finish for the shaders; lengths are in pixels of the frame.
/// @param sphereRows  how many lit spheres the frame has
shared::FinishParams makeFinishParams(const Frame& frame, int sphereRows, DepthSteps steps);

}  // namespace velum::render
