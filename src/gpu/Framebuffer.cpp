#include "gpu/Framebuffer.h"

#include <fmt/format.h>

#include <vector>

#include "gpu/Gl.h"
#include "gpu/GpuError.h"

namespace velum::gpu {

void deleteFramebuffer(unsigned id) {
  if (hasGl()) gl().DeleteFramebuffers(1, &id);
}

namespace {
unsigned createFramebuffer() {
  unsigned id = 0;
  gl().CreateFramebuffers(1, &id);
  return id;
}
}  // namespace

Framebuffer::Framebuffer(std::string_view label, std::initializer_list<const Texture*> colors, const Texture* depth)
    : Handle(createFramebuffer()) {
  gl().ObjectLabel(GL_FRAMEBUFFER, id(), GLsizei(label.size()), label.data());
  std::vector<GLenum> buffers;
  for (const Texture* color : colors) {
    buffers.push_back(GLenum(GL_COLOR_ATTACHMENT0 + buffers.size()));
    gl().NamedFramebufferTexture(id(), buffers.back(), color->id(), 0);
    mIsInteger.push_back(isInteger(color->format()));
    mSize = glm::ivec2(color->size());
  }
  gl().NamedFramebufferDrawBuffers(id(), GLsizei(buffers.size()), buffers.data());
  if (depth) {
    gl().NamedFramebufferTexture(id(), GL_DEPTH_ATTACHMENT, depth->id(), 0);
    mSize = glm::ivec2(depth->size());
  }
  if (gl().CheckNamedFramebufferStatus(id(), GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw GpuError(fmt::format("the driver cannot draw into {}", label));
}

void Framebuffer::clear(glm::vec4 color, float depth) const {
  const GLuint zero[4] = {};
  for (std::size_t i = 0; i < mIsInteger.size(); ++i)
    if (mIsInteger[i])
      gl().ClearNamedFramebufferuiv(id(), GL_COLOR, GLint(i), zero);
    else
      gl().ClearNamedFramebufferfv(id(), GL_COLOR, GLint(i), &color.x);
  gl().DepthMask(GL_TRUE);
  gl().ClearNamedFramebufferfv(id(), GL_DEPTH, 0, &depth);
}

void Framebuffer::bind() const {
  gl().BindFramebuffer(GL_FRAMEBUFFER, id());
  gl().Viewport(0, 0, mSize.x, mSize.y);
}

void present(const Framebuffer& source, unsigned target, glm::ivec2 size) {
  gl().BlitNamedFramebuffer(source.id(), target, 0, 0, source.size().x, source.size().y, 0, size.y, size.x, 0,
                            GL_COLOR_BUFFER_BIT, GL_LINEAR);
}

}  // namespace velum::gpu
