#pragma once
#include "render/FrameSetup.h"
#include "scene/Finishes.h"
#include "shared/finish.h"

namespace velum::render {

/// Number of steps in which the phases of strokes spread, one cell a step.
constexpr int kStrokeSteps = 12;

/// True when the finish needs to know what each sample of the picture shows.
bool needsSamples(const scene::Finish& finish);

/// How many pixels around what is seen its lines go, and what they depend on.
int lineMargin(const Frame& frame);

/// The parameters of a frame's finish for the shaders; lengths are in pixels of the frame.
/// @param sphereRows  how many lit spheres the frame has
/// @param steps  scene frame
shared::FinishParams makeFinishParams(const Frame& frame, int sphereRows, scene::DepthSteps steps);

}  // namespace velum::render
