#pragma once
#include "render/FrameData.h"
#include "shared/instance.h"

namespace velum::render {

/// What a shader is told of a view of a model's instances. The size and the tiles are the target's to say.
/// The eye's, in a sample of the picture.
shared::InstanceView eyeViewOf(const FrameData& data, int sample);
/// The key light's of what the eye sees of the model: a square about it.
shared::InstanceView lightViewOf(const FrameData& data, const shared::InstanceView& eye);

}  // namespace velum::render
