#include "gpu/Draw.h"

#include "gpu/Gl.h"
#include "shared/draw.h"

namespace velum::gpu {

namespace {

GLenum modeOf(Primitive primitive) { return primitive == Primitive::Lines ? GL_LINES : GL_TRIANGLES; }

void prepare(const Program& program, GLuint vertexArray, const DrawState& state) {
  program.use();
  auto toggle = [](GLenum what, bool on) { on ? gl().Enable(what) : gl().Disable(what); };
  toggle(GL_DEPTH_TEST, state.depthTest);
  toggle(GL_BLEND, state.blend);
  gl().DepthFunc(GL_LEQUAL);
  gl().DepthMask(state.depthWrite ? GL_TRUE : GL_FALSE);
  gl().BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl().BindVertexArray(vertexArray);
}

void drawArrays(Primitive primitive, const DrawRange& r) {
  gl().DrawArraysInstancedBaseInstance(modeOf(primitive), r.firstVertex, r.vertices, r.instances,
                                       GLuint(r.firstInstance));
}

/// Where a buffer's byte is, in the way that OpenGL wants it.
const void* byteAt(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

}  // namespace

void draw(const Program& program, Primitive primitive, const DrawRange& range, const DrawState& state) {
  prepare(program, gl().emptyVertexArray, state);
  drawArrays(primitive, range);
}

void draw(const Program& program, const VertexArray& vertices, Primitive primitive, const DrawRange& range,
          const DrawState& state) {
  prepare(program, vertices.id(), state);
  drawArrays(primitive, range);
}

void drawIndexed(const Program& program, const VertexArray& vertices, Primitive primitive, const DrawRange& range,
                 const DrawState& state) {
  prepare(program, vertices.id(), state);
  gl().DrawElementsInstancedBaseVertexBaseInstance(modeOf(primitive), range.vertices, GL_UNSIGNED_INT,
                                                   byteAt(std::size_t(range.firstVertex) * 4), range.instances,
                                                   range.baseVertex, GLuint(range.firstInstance));
}

void drawIndirect(const Program& program, const VertexArray& vertices, Primitive primitive, const Buffer& commands,
                  int first, int count, const DrawState& state) {
  prepare(program, vertices.id(), state);
  gl().BindBuffer(GL_DRAW_INDIRECT_BUFFER, commands.id());
  constexpr std::size_t kStride = sizeof(shared::DrawCommand);
  gl().MultiDrawArraysIndirect(modeOf(primitive), byteAt(std::size_t(first) * kStride), count, GLsizei(kStride));
}

void drawIndexedIndirect(const Program& program, const VertexArray& vertices, Primitive primitive,
                         const Buffer& commands, int first, int count, const DrawState& state) {
  prepare(program, vertices.id(), state);
  gl().BindBuffer(GL_DRAW_INDIRECT_BUFFER, commands.id());
  constexpr std::size_t kStride = sizeof(shared::DrawIndexedCommand);
  gl().MultiDrawElementsIndirect(modeOf(primitive), GL_UNSIGNED_INT, byteAt(std::size_t(first) * kStride), count,
                                 GLsizei(kStride));
}

}  // namespace velum::gpu
