// Draws and dispatches whose counts a shader writes, as OpenGL reads them from a buffer.
#ifndef VELUM_SHARED_DRAW_H
#define VELUM_SHARED_DRAW_H
#include "shared/types.h"
SHARED_BEGIN

struct DrawCommand {
  uint vertexCount;
  uint instanceCount;
  uint firstVertex;
  uint firstInstance;  ///< added to the place of attributes by instance, not to gl_InstanceID
};

/// Five words, the rest is padding: groups of four scalars lie alike in every layout.
struct DrawIndexedCommand {
  uint indexCount;
  uint instanceCount;
  uint firstIndex;
  int baseVertex;      ///< added to each index
  uint firstInstance;
  uint padding0;
  uint padding1;
  uint padding2;
};

/// Groups that are many lie in rows of so many (shaders/common/line.glsl): OpenGL promises 65,535 along an axis.
SHARED_CONST uint kGroupsAcross = 32768u;

struct DispatchCommand {
  uint groupsX;
  uint groupsY;
  uint groupsZ;
  uint padding;
};

SHARED_END
#endif
