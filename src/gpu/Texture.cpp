#include "gpu/Texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "core/Assert.h"
#include "gpu/Allocation.h"
#include "gpu/Context.h"
#include "gpu/Gl.h"
#include "gpu/GpuError.h"

namespace velum::gpu {

namespace {

struct FormatRow {
  GLenum internal, format, type;
  std::size_t bytes;
};

const FormatRow& row(Format format) {
  static constexpr FormatRow kRows[] = {{GL_R8, GL_RED, GL_UNSIGNED_BYTE, 1},
                                        {GL_RG8, GL_RG, GL_UNSIGNED_BYTE, 2},
                                        {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4},
                                        {GL_R16, GL_RED, GL_UNSIGNED_SHORT, 2},
                                        {GL_R16F, GL_RED, GL_HALF_FLOAT, 2},
                                        {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, 8},
                                        {GL_R32F, GL_RED, GL_FLOAT, 4},
                                        {GL_RG32F, GL_RG, GL_FLOAT, 8},
                                        {GL_RGBA32F, GL_RGBA, GL_FLOAT, 16},
                                        {GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, 1},
                                        {GL_RG8UI, GL_RG_INTEGER, GL_UNSIGNED_BYTE, 2},
                                        {GL_R16UI, GL_RED_INTEGER, GL_UNSIGNED_SHORT, 2},
                                        {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 4},
                                        {GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT, 8},
                                        {GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, 16},
                                        {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 4}};
  return kRows[static_cast<int>(format)];
}

unsigned createTexture(GLenum target, std::string_view label, Filter filter, int levels) {
  unsigned id = 0;
  gl().CreateTextures(target, 1, &id);
  gl().ObjectLabel(GL_TEXTURE, id, GLsizei(label.size()), label.data());
  int mode = filter == Filter::Linear ? GL_LINEAR : GL_NEAREST;
  int smaller = filter == Filter::Linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_NEAREST;
  gl().TextureParameteri(id, GL_TEXTURE_MIN_FILTER, levels > 1 ? smaller : mode);
  gl().TextureParameteri(id, GL_TEXTURE_MAG_FILTER, mode);
  for (GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    gl().TextureParameteri(id, axis, GL_CLAMP_TO_EDGE);
  return id;
}

/// What a texture takes, of all its levels.
Allocation allocationOf(std::string_view label, Format format, glm::ivec3 size, int levels) {
  std::size_t bytes = 0;
  for (int level = 0; level < levels; ++level) {
    glm::ivec3 at = glm::max(glm::ivec3(size.x >> level, size.y >> level, size.z >> level), glm::ivec3(1));
    bytes += std::size_t(at.x) * std::size_t(at.y) * std::size_t(at.z) * row(format).bytes;
  }
  return {label, bytes, size};
}

}  // namespace

bool isInteger(Format f) {
  return f == Format::R8ui || f == Format::Rg8ui || f == Format::R16ui || f == Format::R32ui || f == Format::Rg32ui ||
         f == Format::Rgba32ui;
}

std::size_t texelBytes(Format format) { return row(format).bytes; }

int levelCountOf(glm::ivec3 size) { return int(std::bit_width(unsigned(std::max({size.x, size.y, size.z, 1})))); }

void deleteTexture(unsigned id) {
  if (hasGl()) gl().DeleteTextures(1, &id);
}

Texture Texture::makeOfBuffer(std::string_view label, Format format, const Buffer& buffer) {
  VELUM_ASSERT(buffer.bytes() % row(format).bytes == 0, "a buffer of texels holds whole ones");
  std::size_t texels = buffer.bytes() / row(format).bytes;
  if (texels > gl().limits->textureBuffer)
    throw GpuError(fmt::format(
        "{}: {} texels are more than the {} that the driver takes in a buffer: use a smaller model, picture or volume",
        label, texels, gl().limits->textureBuffer));
  unsigned id = 0;
  gl().CreateTextures(GL_TEXTURE_BUFFER, 1, &id);
  gl().ObjectLabel(GL_TEXTURE, id, GLsizei(label.size()), label.data());
  gl().TextureBuffer(id, row(format).internal, buffer.id());
  return Texture(id, format, {int(texels), 1, 1}, false);
}

Texture Texture::make2d(std::string_view label, Format format, glm::ivec2 size, Filter filter, int levels) {
  Texture texture(createTexture(GL_TEXTURE_2D, label, isInteger(format) ? Filter::Nearest : filter, levels), format,
                  {size, 1}, false, levels);
  allocate(allocationOf(label, format, texture.mSize, levels), Answer::AtOnce,
           [&] { gl().TextureStorage2D(texture.id(), levels, row(format).internal, size.x, size.y); });
  return texture;
}

Texture Texture::make3d(std::string_view label, Format format, glm::ivec3 size, Filter filter, int levels) {
  Texture texture(createTexture(GL_TEXTURE_3D, label, isInteger(format) ? Filter::Nearest : filter, levels), format,
                  size, true, levels);
  allocate(allocationOf(label, format, size, levels), Answer::AtOnce,
           [&] { gl().TextureStorage3D(texture.id(), levels, row(format).internal, size.x, size.y, size.z); });
  return texture;
}

glm::ivec3 Texture::size(int level) const {
  return glm::max(glm::ivec3(mSize.x >> level, mSize.y >> level, mSize.z >> level), glm::ivec3(1));
}

void Texture::write(glm::ivec3 o, glm::ivec3 s, const void* texels, int level) {
  const auto& r = row(mFormat);
  VELUM_ASSERT(glm::all(glm::greaterThanEqual(o, glm::ivec3(0))) && glm::all(glm::lessThanEqual(o + s, size(level))),
               "what is written lies in the texture");
  if (mIs3d)
    gl().TextureSubImage3D(id(), level, o.x, o.y, o.z, s.x, s.y, s.z, r.format, r.type, texels);
  else
    gl().TextureSubImage2D(id(), level, o.x, o.y, s.x, s.y, r.format, r.type, texels);
}

void Texture::read(void* texels, std::size_t bytes, int level) const {
  const auto& r = row(mFormat);
  gl().GetTextureImage(id(), level, r.format, r.type, GLsizei(bytes), texels);
}

void Texture::read(glm::ivec3 o, glm::ivec3 s, void* texels, std::size_t bytes, int level) const {
  const auto& r = row(mFormat);
  VELUM_ASSERT(glm::all(glm::greaterThanEqual(o, glm::ivec3(0))) && glm::all(glm::lessThanEqual(o + s, size(level))),
               "what is read lies in the texture");
  if (o.z > 0) return alone(o, s, level).read({0, 0, 0}, s, texels, bytes);
  gl().GetTextureSubImage(id(), level, o.x, o.y, o.z, s.x, s.y, s.z, r.format, r.type, GLsizei(bytes), texels);
}

/// A box by itself. Where Mesa reads by a shader, as zink does for GPUs, it passes over the first layer that is asked
/// for.
Texture Texture::alone(glm::ivec3 o, glm::ivec3 s, int level) const {
  Texture box = make3d("box", mFormat, s, Filter::Nearest);
  gl().CopyImageSubData(id(), GL_TEXTURE_3D, level, o.x, o.y, o.z, box.id(), GL_TEXTURE_3D, 0, 0, 0, 0, s.x, s.y, s.z);
  return box;
}

void Texture::copyTo(Buffer& target, glm::ivec3 o, glm::ivec3 s, int level) const {
  gl().BindBuffer(GL_PIXEL_PACK_BUFFER, target.id());
  read(o, s, nullptr, target.bytes(), level);
  gl().BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

void Texture::copyFrom(const Texture& other, glm::ivec3 o, glm::ivec3 s) {
  auto target = [](const Texture& of) { return of.mIs3d ? GL_TEXTURE_3D : GL_TEXTURE_2D; };
  gl().CopyImageSubData(other.id(), target(other), 0, o.x, o.y, o.z, id(), target(*this), 0, o.x, o.y, o.z, s.x, s.y,
                        s.z);
}

void Texture::clear() {
  const auto& r = row(mFormat);
  gl().ClearTexImage(id(), 0, r.format, r.type, nullptr);
}

void Texture::generateLevels() { gl().GenerateTextureMipmap(id()); }

void Texture::bindSampler(unsigned unit) const { gl().BindTextureUnit(unit, id()); }

void Texture::setComponents(const std::array<Component, 4>& components) {
  static constexpr int kGl[] = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_ZERO, GL_ONE};
  static constexpr GLenum kOf[] = {GL_TEXTURE_SWIZZLE_R, GL_TEXTURE_SWIZZLE_G, GL_TEXTURE_SWIZZLE_B,
                                   GL_TEXTURE_SWIZZLE_A};
  for (std::size_t i = 0; i < 4; ++i) gl().TextureParameteri(id(), kOf[i], kGl[static_cast<int>(components[i])]);
}

void Texture::bindImage(unsigned unit, Access access, int level) const {
  static constexpr GLenum kAccess[] = {GL_READ_ONLY, GL_WRITE_ONLY, GL_READ_WRITE};
  gl().BindImageTexture(unit, id(), level, mIs3d ? GL_TRUE : GL_FALSE, 0, kAccess[static_cast<int>(access)],
                        row(mFormat).internal);
}

}  // namespace velum::gpu
