#include "gpu/Texture.h"

#include <cstddef>
#include <cstring>
#include <vector>

#include "GlFixture.h"
#include "ProbeShaders.h"
#include "gpu/Buffer.h"
#include "gpu/Framebuffer.h"
#include "gpu/GpuError.h"
#include "gpu/Program.h"

namespace velum::gpu {
namespace {

class TextureGL : public GlTest {};

struct Row {
  Format format;
  std::size_t bytes;
};
constexpr Row kFormats[] = {{Format::R8, 1},       {Format::Rg8, 2},     {Format::Rgba8, 4},    {Format::R16, 2},
                            {Format::R16f, 2},     {Format::Rgba16f, 8}, {Format::R32f, 4},     {Format::Rg32f, 8},
                            {Format::Rgba32f, 16}, {Format::R8ui, 1},    {Format::Rg8ui, 2},    {Format::R16ui, 2},
                            {Format::R32ui, 4},    {Format::Rg32ui, 8},  {Format::Rgba32ui, 16}};

/// Bytes that are a finite number in every format: small ones, with the high byte of floats kept harmless.
std::vector<std::byte> patternOf(std::size_t bytes) {
  std::vector<std::byte> pattern(bytes);
  for (std::size_t i = 0; i < bytes; ++i) pattern[i] = std::byte((i * 37 + i / 13) & 0x3b);
  return pattern;
}

TEST_F(TextureGL, EveryFormatGivesBackItsBytes) {
  for (const Row& row : kFormats) {
    // Odd sides: rows are not aligned to four bytes.
    glm::ivec3 size(7, 5, 3);
    std::size_t bytes = std::size_t(7 * 5 * 3) * row.bytes;
    EXPECT_EQ(texelBytes(row.format), row.bytes);
    Texture texture = Texture::make3d("test", row.format, size, Filter::Nearest);
    auto in = patternOf(bytes);
    std::vector<std::byte> out(bytes);
    texture.write({0, 0, 0}, size, in.data());
    texture.read(out.data(), bytes);
    EXPECT_EQ(out, in) << "3D format " << static_cast<int>(row.format);
    Texture flat = Texture::make2d("test", row.format, {7, 5});
    std::size_t flatBytes = 35 * row.bytes;
    out.assign(flatBytes, std::byte(0));
    flat.write({0, 0, 0}, {7, 5, 1}, in.data());
    flat.read(out.data(), flatBytes);
    EXPECT_TRUE(std::equal(out.begin(), out.end(), in.begin())) << "2D format " << static_cast<int>(row.format);
  }
}

TEST_F(TextureGL, WholeNumbersComeToShadersWhateverFilterIsAskedFor) {
  // Drivers read 0 from a texture of whole numbers that is to be filtered.
  ProbeShaders probes;
  probes.add("look.comp", R"(layout(local_size_x = 1) in;
layout(binding = 0) uniform usampler2D picture;
layout(std430, binding = 0) writeonly buffer SeenBlock { uint seen; };
void main() { seen = texelFetch(picture, ivec2(1, 0), 0).r; }
)");
  Program program = probes.make({"look.comp"});
  for (Format format : {Format::R8ui, Format::Rg8ui, Format::R16ui, Format::R32ui, Format::Rg32ui, Format::Rgba32ui}) {
    EXPECT_TRUE(isInteger(format)) << static_cast<int>(format);
    Texture texture = Texture::make2d("test", format, {2, 2}, Filter::Linear);
    auto texels = patternOf(4 * texelBytes(format));
    texture.write({0, 0, 0}, {2, 2, 1}, texels.data());
    std::uint32_t wanted = 0, seen = 0;
    std::size_t channels = format == Format::Rgba32ui ? 4 : format == Format::Rg8ui || format == Format::Rg32ui ? 2 : 1;
    std::memcpy(&wanted, texels.data() + texelBytes(format), texelBytes(format) / channels);
    Buffer out("seen", sizeof seen);
    out.bindStorage(0);
    texture.bindSampler(0);
    dispatch(program, {1, 1, 1});
    barrier();
    out.read(0, sizeof seen, &seen);
    EXPECT_EQ(seen, wanted) << static_cast<int>(format);
    EXPECT_NE(seen, 0u) << static_cast<int>(format);
  }
  for (Format format : {Format::R8, Format::Rgba8, Format::R16, Format::R16f, Format::R32f, Format::Depth32f})
    EXPECT_FALSE(isInteger(format)) << static_cast<int>(format);
}

TEST_F(TextureGL, ABoxIsWrittenAndReadWhereItIs) {
  Texture texture = Texture::make3d("test", Format::R16, {8, 6, 5});
  texture.clear();
  std::vector<std::uint16_t> box(2 * 3 * 2);
  for (std::size_t i = 0; i < box.size(); ++i) box[i] = std::uint16_t(1000 + i);
  texture.write({3, 1, 2}, {2, 3, 2}, box.data());
  std::vector<std::uint16_t> all(8 * 6 * 5), part(box.size());
  texture.read(all.data(), all.size() * 2);
  for (int z = 0; z < 5; ++z)
    for (int y = 0; y < 6; ++y)
      for (int x = 0; x < 8; ++x) {
        bool inside = x >= 3 && x < 5 && y >= 1 && y < 4 && z >= 2 && z < 4;
        int expected = inside ? 1000 + ((z - 2) * 3 + (y - 1)) * 2 + (x - 3) : 0;
        EXPECT_EQ(all[std::size_t((z * 6 + y) * 8 + x)], expected);
      }
  texture.read({3, 1, 2}, {2, 3, 2}, part.data(), part.size() * 2);
  EXPECT_EQ(part, box);
}

TEST_F(TextureGL, ClearsToZero) {
  Texture texture = Texture::make2d("test", Format::Rgba32f, {3, 3});
  std::vector<glm::vec4> texels(9, glm::vec4(3.5f));
  texture.write({0, 0, 0}, {3, 3, 1}, texels.data());
  texture.clear();
  texture.read(texels.data(), 9 * sizeof(glm::vec4));
  for (auto& texel : texels) EXPECT_EQ(texel, glm::vec4(0.0f));
}

TEST_F(TextureGL, AFramebufferClearsEveryAttachment) {
  Texture a = Texture::make2d("a", Format::Rgba32f, {4, 2}), b = Texture::make2d("b", Format::Rgba32f, {4, 2});
  Texture depth = Texture::make2d("depth", Format::Depth32f, {4, 2});
  Framebuffer target("test", {&a, &b}, &depth);
  EXPECT_EQ(target.size(), glm::ivec2(4, 2));
  target.clear({0.25f, 0.5f, 0.75f, 1.0f}, 1.0f);
  for (const Texture* texture : {&a, &b}) {
    std::vector<glm::vec4> texels(8);
    texture->read(texels.data(), 8 * sizeof(glm::vec4));
    for (auto& texel : texels) EXPECT_EQ(texel, glm::vec4(0.25f, 0.5f, 0.75f, 1.0f));
  }
}

TEST_F(TextureGL, ASizeThatTheDriverLacksIsAnErrorOfOurs) {
  int most = context().limits().texture3d;
  EXPECT_THROW(Texture::make3d("too long", Format::R8, {most * 2, 1, 1}), GpuError);
}

}  // namespace
}  // namespace velum::gpu
