#pragma once
#include <glm/glm.hpp>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "gpu/Handle.h"
#include "gpu/Texture.h"

namespace velum::gpu {

void deleteFramebuffer(unsigned id);

/// The target of draws: textures of ours. GL thread.
class Framebuffer : public Handle<deleteFramebuffer> {
 public:
  Framebuffer() = default;
  Framebuffer(std::string_view label, std::initializer_list<const Texture*> colors, const Texture* depth = nullptr);
  /// Sets all colour attachments and the depth; integer attachments become 0 whatever @p color is.
  void clear(glm::vec4 color, float depth) const;
  /// Makes this framebuffer the target of draws and sets the viewport to its whole size.
  void bind() const;
  glm::ivec2 size() const { return mSize; }

 private:
  glm::ivec2 mSize{0};
  std::vector<bool> mIsInteger;  ///< of the colour attachments
};

/// Copies a texture's colours into a framebuffer by GL name (0 is the window), scaled linearly to its size; flips rows
/// so that a top-row-first texture stands upright.
void present(const Framebuffer& source, unsigned targetFramebuffer, glm::ivec2 targetSize);

}  // namespace velum::gpu
