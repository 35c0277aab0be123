// Levels of textures against means taken on the processor.
#include <cmath>
#include <vector>

#include "GlFixture.h"
#include "ProbeShaders.h"
#include "gpu/Texture.h"

namespace velum::gpu {
namespace {

class LevelsGL : public GlTest {};

/// The next level of a box of floats whose sides are even or 1.
std::vector<float> halve(const std::vector<float>& in, glm::ivec3 size) {
  glm::ivec3 half = glm::max(size / 2, glm::ivec3(1)), step = size / half;
  std::vector<float> out;
  for (int z = 0; z < half.z; ++z)
    for (int y = 0; y < half.y; ++y)
      for (int x = 0; x < half.x; ++x) {
        double sum = 0;
        for (int c = 0; c < step.z; ++c)
          for (int b = 0; b < step.y; ++b)
            for (int a = 0; a < step.x; ++a)
              sum += double(in[std::size_t(((z * step.z + c) * size.y + y * step.y + b) * size.x + x * step.x + a)]);
        out.push_back(float(sum / (step.x * step.y * step.z)));
      }
  return out;
}

std::vector<float> patternOf(glm::ivec3 size) {
  std::vector<float> values;
  for (int i = 0; i < size.x * size.y * size.z; ++i) values.push_back(0.5f + 0.5f * std::sin(float(i * i % 977)));
  return values;
}

TEST_F(LevelsGL, SizesAreHalvedDownToOne) {
  EXPECT_EQ(levelCountOf({1, 1, 1}), 1);
  EXPECT_EQ(levelCountOf({8, 2, 1}), 4);
  EXPECT_EQ(levelCountOf({9, 2, 15}), 4);
  EXPECT_EQ(levelCountOf({9, 2, 16}), 5);
  Texture texture = Texture::make3d("test", Format::R8, {9, 4, 2}, Filter::Linear, 4);
  EXPECT_EQ(texture.levelCount(), 4);
  EXPECT_EQ(texture.size(0), glm::ivec3(9, 4, 2));
  EXPECT_EQ(texture.size(1), glm::ivec3(4, 2, 1));
  EXPECT_EQ(texture.size(3), glm::ivec3(1, 1, 1));
}

TEST_F(LevelsGL, GeneratedLevelsAreTheMeansOfTheOnesBefore) {
  for (glm::ivec3 size : {glm::ivec3(32, 16, 8), glm::ivec3(16, 16, 1), glm::ivec3(64, 4, 1)}) {
    bool isFlat = size.z == 1;
    int levels = levelCountOf(size);
    Texture texture = isFlat ? Texture::make2d("test", Format::R32f, glm::ivec2(size), Filter::Linear, levels)
                             : Texture::make3d("test", Format::R32f, size, Filter::Linear, levels);
    std::vector<float> expected = patternOf(size);
    texture.write({0, 0, 0}, size, expected.data());
    texture.generateLevels();
    for (int level = 1; level < levels; ++level) {
      expected = halve(expected, texture.size(level - 1));
      std::vector<float> seen(expected.size());
      texture.read(seen.data(), seen.size() * sizeof(float), level);
      // Drivers filter with weights of eight bits at the least.
      for (std::size_t i = 0; i < seen.size(); ++i)
        ASSERT_NEAR(seen[i], expected[i], level * 1.0 / 256) << "texel " << i << " of level " << level;
    }
  }
}

TEST_F(LevelsGL, ALevelIsWrittenWithoutTheOthers) {
  Texture texture = Texture::make2d("test", Format::R16ui, {8, 8}, Filter::Nearest, 3);
  for (int level = 0; level < 3; ++level) {
    glm::ivec3 size = texture.size(level);
    std::vector<std::uint16_t> values(std::size_t(size.x * size.y), std::uint16_t(100 + level));
    texture.write({0, 0, 0}, size, values.data(), level);
  }
  std::uint16_t corner = 9;
  texture.write({3, 2, 0}, {1, 1, 1}, &corner, 1);
  for (int level = 0; level < 3; ++level) {
    glm::ivec3 size = texture.size(level);
    std::vector<std::uint16_t> seen(std::size_t(size.x * size.y)), expected(seen.size(), std::uint16_t(100 + level));
    if (level == 1) expected[2 * 4 + 3] = 9;
    texture.read(seen.data(), seen.size() * 2, level);
    EXPECT_EQ(seen, expected) << "level " << level;
    texture.read({size.x - 1, size.y / 2, 0}, {1, 1, 1}, &corner, 2, level);
    EXPECT_EQ(corner, level == 1 ? 9 : 100 + level);
  }
}

TEST_F(LevelsGL, AShaderMakesALevelFromTheOneBefore) {
  // Largest values, as a pyramid for culling is made: no filter of the driver's can do it.
  ProbeShaders probes;
  probes.add("halve.comp", R"(layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
layout(binding = 0, r32f) uniform readonly image3D finer;
layout(binding = 1, r32f) uniform writeonly image3D coarser;
void main() {
  ivec3 to = ivec3(gl_GlobalInvocationID);
  if (any(greaterThanEqual(to, imageSize(coarser)))) return;
  float most = 0.0;
  for (int i = 0; i < 8; ++i) most = max(most, imageLoad(finer, to * 2 + ivec3(i & 1, i >> 1 & 1, i >> 2)).r);
  imageStore(coarser, to, vec4(most));
}
)");
  Program program = probes.make({"halve.comp"});
  glm::ivec3 size(16, 16, 16);
  Texture texture = Texture::make3d("pyramid", Format::R32f, size, Filter::Nearest, levelCountOf(size));
  std::vector<float> values = patternOf(size);
  texture.write({0, 0, 0}, size, values.data());
  for (int level = 1; level < texture.levelCount(); ++level) {
    texture.bindImage(0, Access::Read, level - 1);
    texture.bindImage(1, Access::Write, level);
    dispatch(program, (texture.size(level) + 3) / 4);
    barrier();
  }
  for (int level = 1; level < texture.levelCount(); ++level) {
    glm::ivec3 half = texture.size(level);
    std::vector<float> seen(std::size_t(half.x * half.y * half.z));
    texture.read(seen.data(), seen.size() * sizeof(float), level);
    for (int i = 0; i < int(seen.size()); ++i) {
      glm::ivec3 at = glm::ivec3(i % half.x, i / half.x % half.y, i / (half.x * half.y)) << level;
      float most = 0;
      for (int z = 0; z < 1 << level; ++z)
        for (int y = 0; y < 1 << level; ++y)
          for (int x = 0; x < 1 << level; ++x)
            most = std::max(most, values[std::size_t(((at.z + z) * 16 + at.y + y) * 16 + at.x + x)]);
      ASSERT_EQ(seen[std::size_t(i)], most) << "texel " << i << " of level " << level;
    }
  }
}

TEST_F(LevelsGL, SamplersReadTheLevelThatTheyAskFor) {
  ProbeShaders probes;
  probes.add("look.comp", R"(layout(local_size_x = 1) in;
layout(binding = 0) uniform sampler2D picture;
layout(std430, binding = 0) writeonly buffer SeenBlock { float seen[]; };
void main() {
  for (int i = 0; i < 5; ++i) seen[i] = textureLod(picture, vec2(0.5), 0.5 * float(i)).r;
}
)");
  Program program = probes.make({"look.comp"});
  for (Filter filter : {Filter::Linear, Filter::Nearest}) {
    Texture texture = Texture::make2d("levels", Format::R32f, {4, 4}, filter, 3);
    for (int level = 0; level < 3; ++level) {
      std::vector<float> values(16, float(10 * level));
      texture.write({0, 0, 0}, texture.size(level), values.data(), level);
    }
    Buffer out("seen", 5 * sizeof(float));
    texture.bindSampler(0);
    out.bindStorage(0);
    dispatch(program, {1, 1, 1});
    barrier();
    float seen[5];
    out.read(0, sizeof seen, seen);
    for (int level = 0; level < 3; ++level) EXPECT_EQ(seen[2 * level], 10.0f * float(level));
    if (filter == Filter::Linear) {
      EXPECT_NEAR(seen[1], 5.0f, 0.1f);
    }
  }
}

}  // namespace
}  // namespace velum::gpu
