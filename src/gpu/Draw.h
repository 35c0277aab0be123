#pragma once
#include "gpu/Buffer.h"
#include "gpu/Program.h"
#include "gpu/VertexArray.h"

namespace velum::gpu {

enum class Primitive { Triangles, Lines };

struct DrawState {
  bool depthTest = true;
  bool depthWrite = true;
  bool blend = false;
};

/// How much one draw draws, and from where. Vertices of an indexed draw are indices.
struct DrawRange {
  int vertices = 0;
  int instances = 1;
  int firstVertex = 0;
  int firstInstance = 0;  ///< For attributes by instance; gl_InstanceID counts from 0 all the same.
  int baseVertex = 0;     ///< Indexed draws: added to each index.
};

/// Draws into the framebuffer that is bound. The vertex shader makes vertices from gl_VertexID and gl_InstanceID, or
/// reads them from a vertex array. GL thread, as all functions here.
void draw(const Program& program, Primitive primitive, const DrawRange& range, const DrawState& state = {});
void draw(const Program& program, const VertexArray& vertices, Primitive primitive, const DrawRange& range,
          const DrawState& state = {});
/// Draws the vertices that the indices of the vertex array name, in the order of the indices.
void drawIndexed(const Program& program, const VertexArray& vertices, Primitive primitive, const DrawRange& range,
                 const DrawState& state = {});
/// Draws what the shared::DrawCommands in a buffer say at the time when the GPU reaches them: for vertices and
/// instances that a shader culls or chooses (shaders/shared/draw.h). After gpu::barrier() where a shader wrote them.
/// @param count  how many commands are drawn, from command `first` on
void drawIndirect(const Program& program, const VertexArray& vertices, Primitive primitive, const Buffer& commands,
                  int first, int count, const DrawState& state = {});
/// As drawIndirect(), but the buffer holds shared::DrawIndexedCommands.
void drawIndexedIndirect(const Program& program, const VertexArray& vertices, Primitive primitive,
                         const Buffer& commands, int first, int count, const DrawState& state = {});

}  // namespace velum::gpu
