#include "gpu/CurrentLimits.h"

#include "gpu/Gl.h"

namespace velum::gpu {

const Limits& currentLimits() { return *gl().limits; }

}  // namespace velum::gpu
