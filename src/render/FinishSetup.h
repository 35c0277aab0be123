#pragma once
#include "render/FrameSetup.h"
#include "shared/finish.h"

namespace velum::render {

/// Steps in which phases of strokes spread, a cell each.
constexpr int kStrokeSteps = 12;

/// True where the finish wants to know what each sample shows.
bool needsSamples(const scene::Finish& finish);

/// What a frame's finish is: lengths in pixels of the frame.
/// @param sphereRows  lit spheres that the frame has  @param stepLength  a jump of depth that counts for contours,
/// scene frame
shared::FinishParams makeFinishParams(const Frame& frame, int sphereRows, double stepLength);

}  // namespace velum::render
