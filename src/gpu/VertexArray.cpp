#include "gpu/VertexArray.h"

#include "gpu/Gl.h"

namespace velum::gpu {

void deleteVertexArray(unsigned id) {
  if (hasGl()) gl().DeleteVertexArrays(1, &id);
}

namespace {
unsigned createVertexArray() {
  unsigned id = 0;
  gl().CreateVertexArrays(1, &id);
  return id;
}
}  // namespace

VertexArray::VertexArray(std::string_view label, std::initializer_list<Attribute> attributes, const Buffer* indices)
    : Handle(createVertexArray()) {
  gl().ObjectLabel(GL_VERTEX_ARRAY, id(), GLsizei(label.size()), label.data());
  if (indices) gl().VertexArrayElementBuffer(id(), indices->id());
  GLuint binding = 0;
  for (const Attribute& a : attributes) {
    std::size_t stride = a.stride ? a.stride : std::size_t(a.components) * 4;
    gl().VertexArrayVertexBuffer(id(), binding, a.buffer->id(), GLintptr(a.offset), GLsizei(stride));
    gl().VertexArrayBindingDivisor(id(), binding, a.perInstance ? 1 : 0);
    gl().EnableVertexArrayAttrib(id(), a.location);
    if (a.type == Attribute::Type::Uint)
      gl().VertexArrayAttribIFormat(id(), a.location, a.components, GL_UNSIGNED_INT, 0);
    else
      gl().VertexArrayAttribFormat(id(), a.location, a.components, GL_FLOAT, GL_FALSE, 0);
    gl().VertexArrayAttribBinding(id(), a.location, binding++);
  }
}

}  // namespace velum::gpu
