#pragma once
#include "render/FrameData.h"
#include "shared/instance.h"

namespace velum::render {

/// Parameters for shaders of a view of a model's instances. The target fills in the size and the tiles. The eye's view,
/// in a sample of the picture. Copies all have slots in it, see ModelPass::eyeView().
shared::InstanceView eyeViewOf(const FrameData& data, int sample);
/// The key light's view: a square about the part of the model that the eye sees.
shared::InstanceView lightViewOf(const FrameData& data, const shared::InstanceView& eye);

}  // namespace velum::render
