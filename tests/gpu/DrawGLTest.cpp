#include "gpu/Draw.h"

#include <map>
#include <vector>

#include "GlFixture.h"
#include "ProbeShaders.h"
#include "gpu/Framebuffer.h"
#include "shared/draw.h"

namespace velum::gpu {
namespace {

constexpr int kSide = 64, kRects = 40;

/// Rectangle i of the shaders below.
glm::ivec4 rectOf(int i) { return {8 * (i % 8), 8 * (i / 8), 1 + i % 7, 1 + i % 5}; }

/// Rectangles of pixels by number, six vertices each; a pixel keeps the number of its rectangle plus one.
constexpr const char* kPlace = R"(
flat out uint number;
void placeCorner(uint i, uvec2 corner) {
  uvec2 pixel = uvec2(8u * (i % 8u), 8u * (i / 8u)) + corner * uvec2(1u + i % 7u, 1u + i % 5u);
  number = i + 1u;
  gl_Position = vec4(vec2(pixel) / 32.0 - 1.0, 0.0, 1.0);
}
uvec2 cornerOf(int vertex) { return uvec2(vertex % 3 == 1 || vertex == 3, vertex % 3 == 2 || vertex == 3); }
)";

class DrawGL : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    mProbes.add("probe.frag",
                "flat in uint number;\nlayout(location = 0) out vec4 color;\nvoid main() { color = vec4(number); }\n");
    mColor = Texture::make2d("drawn", Format::R32f, {kSide, kSide});
    mTarget = Framebuffer("drawn", {&mColor});
  }
  Program makeProgram(const std::string& main) {
    mProbes.add("probe.vert", kPlace + main);
    return mProbes.make({"probe.vert", "probe.frag"});
  }
  void clear() {
    mTarget.clear(glm::vec4(0.0f), 1.0f);
    mTarget.bind();
  }
  /// How many pixels each rectangle has.
  std::map<int, int> countPixels() const {
    std::vector<float> pixels(kSide * kSide);
    mColor.read(pixels.data(), pixels.size() * sizeof(float));
    std::map<int, int> counts;
    for (float pixel : pixels)
      if (pixel != 0) ++counts[int(pixel) - 1];
    return counts;
  }
  template <class Choose>
  static std::map<int, int> expectedPixels(Choose&& isDrawn) {
    std::map<int, int> counts;
    for (int i = 0; i < kRects; ++i)
      if (isDrawn(i)) counts[i] = rectOf(i).z * rectOf(i).w;
    return counts;
  }

  ProbeShaders mProbes;
  Texture mColor;
  Framebuffer mTarget;
  DrawState mFlat{.depthTest = false};
};

TEST_F(DrawGL, InstancesDrawEachTheirOwn) {
  Program program = makeProgram("void main() { placeCorner(uint(gl_InstanceID), cornerOf(gl_VertexID)); }");
  clear();
  draw(program, Primitive::Triangles, {.vertices = 6, .instances = kRects}, mFlat);
  EXPECT_EQ(countPixels(), expectedPixels([](int) { return true; }));
  clear();
  // The first triangle of two alone: the diagonal belongs to one of them.
  draw(program, Primitive::Triangles, {.vertices = 6, .instances = 3}, mFlat);
  EXPECT_EQ(countPixels(), expectedPixels([](int i) { return i < 3; }));
}

TEST_F(DrawGL, WhatOnlyTestsDepthDoesNotWriteIt) {
  Program near = makeProgram("void main() { placeCorner(0u, cornerOf(gl_VertexID)); gl_Position.z = -0.5; }");
  Program far =
      makeProgram("void main() { placeCorner(0u, cornerOf(gl_VertexID)); number = 8u; gl_Position.z = 0.5; }");
  Texture depth = Texture::make2d("depth", Format::Depth32f, {kSide, kSide});
  mTarget = Framebuffer("drawn", {&mColor}, &depth);
  const DrawState tests{.depthTest = true, .depthWrite = false}, writes{};
  clear();
  draw(near, Primitive::Triangles, {.vertices = 6}, writes);
  draw(far, Primitive::Triangles, {.vertices = 6}, tests);
  EXPECT_EQ(countPixels(), (std::map<int, int>{{0, 1}})) << "the nearer one hides the farther one";
  clear();
  draw(near, Primitive::Triangles, {.vertices = 6}, tests);
  draw(far, Primitive::Triangles, {.vertices = 6}, writes);
  EXPECT_EQ(countPixels(), (std::map<int, int>{{7, 1}})) << "it has left no depth behind";
}

TEST_F(DrawGL, AttributesByInstanceStartAtTheFirstInstance) {
  Program program =
      makeProgram("layout(location = 0) in uint rect;\nvoid main() { placeCorner(rect, cornerOf(gl_VertexID)); }");
  std::vector<std::uint32_t> order(kRects);
  for (int i = 0; i < kRects; ++i) order[std::size_t(i)] = std::uint32_t(kRects - 1 - i);
  Buffer rects("rects", std::span<const std::uint32_t>(order));
  VertexArray vertices(
      "rects",
      {{.location = 0, .buffer = &rects, .components = 1, .type = Attribute::Type::Uint, .perInstance = true}});
  clear();
  draw(program, vertices, Primitive::Triangles, {.vertices = 6, .instances = 7, .firstInstance = 5}, mFlat);
  EXPECT_EQ(countPixels(), expectedPixels([](int i) { return i <= kRects - 1 - 5 && i > kRects - 1 - 12; }));
}

/// The four corners of a few rectangles as a buffer of places, and the indices of their triangles.
struct Mesh {
  std::vector<glm::vec2> places;
  std::vector<std::uint32_t> indices;
};
Mesh meshOf(int first, int count) {
  Mesh mesh;
  for (int i = first; i < first + count; ++i) {
    auto base = std::uint32_t(mesh.places.size());
    glm::ivec4 r = rectOf(i);
    for (int corner = 0; corner < 4; ++corner)
      mesh.places.emplace_back(r.x + (corner & 1) * r.z, r.y + (corner >> 1) * r.w);
    for (std::uint32_t index : {0u, 1u, 2u, 2u, 1u, 3u}) mesh.indices.push_back(base + index);
  }
  return mesh;
}
constexpr const char* kMeshMain = R"(
layout(location = 3) in vec2 place;
layout(location = 4) in float name;
void main() {
  number = uint(name);
  gl_Position = vec4(place / 32.0 - 1.0, 0.0, 1.0);
}
)";

TEST_F(DrawGL, IndicesChooseVerticesAndTheBaseMovesThem) {
  Program program = makeProgram(kMeshMain);
  Mesh mesh = meshOf(0, kRects);
  std::vector<glm::vec3> rows;  // place and name together, in one buffer
  for (std::size_t i = 0; i < mesh.places.size(); ++i) rows.emplace_back(mesh.places[i], float(i / 4 + 1));
  Buffer places("places", std::span<const glm::vec3>(rows)),
      indices("indices", std::span<const std::uint32_t>(mesh.indices));
  VertexArray vertices("mesh",
                       {{.location = 3, .buffer = &places, .components = 2, .stride = sizeof(glm::vec3)},
                        {.location = 4, .buffer = &places, .components = 1, .offset = 8, .stride = sizeof(glm::vec3)}},
                       &indices);
  clear();
  drawIndexed(program, vertices, Primitive::Triangles, {.vertices = int(mesh.indices.size())}, mFlat);
  EXPECT_EQ(countPixels(), expectedPixels([](int) { return true; }));
  clear();
  drawIndexed(program, vertices, Primitive::Triangles, {.vertices = 12, .firstVertex = 6, .baseVertex = 4 * 3}, mFlat);
  EXPECT_EQ(countPixels(), expectedPixels([](int i) { return i == 4 || i == 5; }));
}

/// Keeps every third rectangle in the one draw, every third of the rest in the other, as a pass that culls would.
constexpr const char* kCull = R"(layout(local_size_x = 64) in;
#include "shared/draw.h"
layout(std430, binding = 0) buffer CommandBlock { COMMAND commands[]; };
layout(std430, binding = 1) writeonly buffer KeptBlock { uint kept[]; };
void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= 40u || i % 3u == 2u) return;
  uint which = i % 3u;
  uint place = atomicAdd(commands[1u + which].instanceCount, 1u);
  kept[which * 64u + place] = i;
}
)";

TEST_F(DrawGL, IndirectDrawsDoWhatAComputeShaderWrote) {
  Program program =
      makeProgram("layout(location = 0) in uint rect;\nvoid main() { placeCorner(rect, cornerOf(gl_VertexID)); }");
  mProbes.add("cull.comp", kCull);
  Program cull = mProbes.make({"cull.comp"}, {{"COMMAND", "DrawCommand"}});
  // A command that is left out stands before them.
  std::vector<shared::DrawCommand> start{{6, 40, 0, 0}, {6, 0, 0, 0}, {6, 0, 0, 64}};
  Buffer commands("commands", std::span<const shared::DrawCommand>(start)), kept("kept", 128 * 4);
  kept.clear();
  VertexArray vertices(
      "kept", {{.location = 0, .buffer = &kept, .components = 1, .type = Attribute::Type::Uint, .perInstance = true}});
  commands.bindStorage(0);
  kept.bindStorage(1);
  dispatch(cull, {1, 1, 1});
  barrier();
  clear();
  drawIndirect(program, vertices, Primitive::Triangles, commands, 1, 2, mFlat);
  EXPECT_EQ(countPixels(), expectedPixels([](int i) { return i % 3 != 2; }));
  clear();
  drawIndirect(program, vertices, Primitive::Triangles, commands, 2, 1, mFlat);
  EXPECT_EQ(countPixels(), expectedPixels([](int i) { return i % 3 == 1; }));
}

TEST_F(DrawGL, IndexedIndirectDrawsDoWhatAComputeShaderWrote) {
  Program program = makeProgram(R"(
layout(location = 0) in uint rect;
layout(location = 1) in uvec2 corner;
void main() { placeCorner(rect, corner); }
)");
  mProbes.add("cull.comp", kCull);
  Program cull = mProbes.make({"cull.comp"}, {{"COMMAND", "DrawIndexedCommand"}});
  const std::uint32_t kIndices[] = {9, 9, 9, 0, 1, 2, 2, 1, 3};
  const glm::uvec2 kCorners[] = {{9, 9}, {9, 9}, {0, 0}, {1, 0}, {0, 1}, {1, 1}};
  std::vector<shared::DrawIndexedCommand> start{{6, 0, 3, 2, 0}, {6, 0, 3, 2, 0}, {6, 0, 3, 2, 64}};
  Buffer commands("commands", std::span<const shared::DrawIndexedCommand>(start)), kept("kept", 128 * 4);
  Buffer corners("corners", std::span<const glm::uvec2>(kCorners)),
      indices("indices", std::span<const std::uint32_t>(kIndices));
  kept.clear();
  auto type = Attribute::Type::Uint;
  VertexArray vertices("kept",
                       {{.location = 0, .buffer = &kept, .components = 1, .type = type, .perInstance = true},
                        {.location = 1, .buffer = &corners, .components = 2, .type = type}},
                       &indices);
  commands.bindStorage(0);
  kept.bindStorage(1);
  dispatch(cull, {1, 1, 1});
  barrier();
  clear();
  drawIndexedIndirect(program, vertices, Primitive::Triangles, commands, 1, 2, mFlat);
  EXPECT_EQ(countPixels(), expectedPixels([](int i) { return i % 3 != 2; }));
}

TEST_F(DrawGL, AnIndirectDispatchRunsAsManyGroupsAsAreWritten) {
  mProbes.add("choose.comp", R"(layout(local_size_x = 1) in;
#include "shared/draw.h"
layout(std430, binding = 0) writeonly buffer CommandBlock { DispatchCommand commands[]; };
void main() { commands[1] = DispatchCommand(3u, 2u, 5u, 0u); }
)");
  mProbes.add("count.comp", R"(layout(local_size_x = 4) in;
layout(std430, binding = 1) buffer CountBlock { uint count; uint farthest; };
void main() {
  atomicAdd(count, 1u);
  atomicMax(farthest, gl_WorkGroupID.x + 10u * gl_WorkGroupID.y + 100u * gl_WorkGroupID.z);
}
)");
  Program choose = mProbes.make({"choose.comp"}), count = mProbes.make({"count.comp"});
  Buffer commands("commands", 2 * sizeof(shared::DispatchCommand)), counts("counts", 16);
  commands.clear();
  counts.clear();
  commands.bindStorage(0);
  counts.bindStorage(1);
  dispatch(choose, {1, 1, 1});
  barrier();
  dispatchIndirect(count, commands, 1);
  dispatchIndirect(count, commands, 0);  // no groups
  barrier();
  glm::uvec2 seen;
  counts.read(0, sizeof seen, &seen);
  EXPECT_EQ(seen, glm::uvec2(4 * 3 * 2 * 5, 2 + 10 * 1 + 100 * 4));
}

}  // namespace
}  // namespace velum::gpu
