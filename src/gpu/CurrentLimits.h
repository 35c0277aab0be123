#pragma once
#include "gpu/Context.h"

namespace velum::gpu {

/// What the driver of this thread's current context offers. The reference lasts as long as the context.
const Limits& currentLimits();

}  // namespace velum::gpu
