// The dispatches that the lists of draws make.
layout(local_size_x = 4) in;

#include "shared/bindings.h"
#include "shared/draw.h"
#include "shared/instance.h"

layout(std430, binding = kCountBinding) buffer CountBlock {
  uint counts[kDrawLists];
  DispatchCommand commands[kDrawLists];
};

void main() {
  uint list = gl_LocalInvocationIndex;
  uint threads = list == uint(kDrawOne) ? 1u : list == uint(kDrawFew) ? uint(kFewThreads) : uint(kInstanceGroup);
  uint inGroup = uint(kInstanceGroup) / threads;
  uint groups = (counts[list] + inGroup - 1u) / inGroup;
  uint across = min(groups, kGroupsAcross);
  uint parts = list == uint(kDrawLarge) ? uint(kLargeParts) : 1u;
  commands[list] = DispatchCommand(across, across == 0u ? 0u : (groups + across - 1u) / across, parts, 0u);
}
