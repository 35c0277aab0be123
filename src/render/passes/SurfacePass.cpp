#include "render/passes/SurfacePass.h"

#include <cstddef>
#include <numeric>
#include <set>
#include <vector>

#include "gpu/Draw.h"
#include "render/WorkQueue.h"
#include "render/passes/Outlines.h"

namespace velum::render {

void SurfacePass::prepare(FrameData& data) {
  bool hasMembranes = (data.params.flags & shared::kFlagMembranes) != 0;
  gpu::Program& program = mPrograms[hasMembranes];
  if (!program)
    program = gpu::Program({"render/surface.vert", "render/surface.frag"},
                           hasMembranes ? gpu::Defines{{"MEMBRANES", "1"}} : gpu::Defines{});
  mProgram = &program;
  forgetMeshes(data);
  resize(opaqueOf(data.frame.scene) != Opaque::None ? data.frame.windowSize : glm::ivec2(1));
}

void SurfacePass::resize(glm::ivec2 size) {
  if (mColor && glm::ivec2(mColor.size()) == size) return;
  mColor = gpu::Texture::make2d("surface colour", gpu::Format::Rgba16f, size);
  mAux = gpu::Texture::make2d("surface normal, distance", gpu::Format::Rgba32f, size);
  mIds = gpu::Texture::make2d("surface ids", gpu::Format::Rgba32ui, size);
  mDepth = gpu::Texture::make2d("surface depth", gpu::Format::Depth32f, size);
  mIsBlank = false;
  mTarget = gpu::Framebuffer("surfaces", {&mColor, &mAux, &mIds}, &mDepth);
}

SurfacePass::MeshKey SurfacePass::keyOf(const Shared<Mesh>& mesh, const FrameData& data) {
  glm::dvec3 origin = sceneOrigin(data.grid);
  return {mesh.id(), {origin.x, origin.y, origin.z, data.unit}};
}

/// Meshes that are not in the scene any more, or not there.
void SurfacePass::forgetMeshes(const FrameData& data) {
  std::set<MeshKey> wanted;
  for (const auto& surface : data.frame.scene.surfaces)
    if (surface.data) wanted.insert(keyOf(surface.data, data));
  std::erase_if(mMeshes, [&](const auto& kept) { return !wanted.contains(kept.first); });
}

SurfacePass::Vertices::Vertices(const char* label, std::span<const Vertex> v, std::span<const std::uint32_t> i)
    : vertices(label, v), indices(label, i), count(int(i.size())) {
  constexpr std::size_t kStride = sizeof(Vertex);
  array = gpu::VertexArray(
      label,
      {{.location = 0, .buffer = &vertices, .components = 3, .stride = kStride},
       {.location = 1, .buffer = &vertices, .components = 3, .offset = offsetof(Vertex, normal), .stride = kStride}},
      &indices);
}

const SurfacePass::Vertices& SurfacePass::verticesOf(const Shared<Mesh>& mesh, const FrameData& data) {
  glm::dvec3 origin = sceneOrigin(data.grid);
  Vertices& known = mMeshes[keyOf(mesh, data)];
  if (known.array) return known;
  std::vector<Vertex> vertices;
  vertices.reserve(mesh->positions.size());
  for (std::size_t i = 0; i < mesh->positions.size(); ++i)
    vertices.push_back({glm::vec3(glm::dvec3(mesh->positions[i]) / data.unit - origin),
                        i < mesh->normals.size() ? mesh->normals[i] : glm::vec3(0.0f)});
  return known = Vertices("mesh", vertices, mesh->indices);
}

void SurfacePass::addSteps(const FrameData& data, int, WorkQueue& queue) {
  queue.add(*this, [this, &data] {
    bool isDrawn = opaqueOf(data.frame.scene) != Opaque::None;
    if (isDrawn || !mIsBlank) mTarget.clear(glm::vec4(0.0f), 1.0f);
    if (isDrawn) draw(data);
    mIsBlank = !isDrawn;
  });
}

void SurfacePass::draw(const FrameData& data) {
  mTarget.bind();
  const auto& surfaces = data.frame.scene.surfaces;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (!isDrawn(surfaces[i])) continue;
    mProgram->set(0, glm::vec4(surfaces[i].color, 1.0f));
    mProgram->set(1, int(shared::kFirstSurfaceInstance + i));
    const Vertices& mesh = verticesOf(surfaces[i].data, data);
    gpu::drawIndexed(*mProgram, mesh.array, gpu::Primitive::Triangles, {mesh.count});
  }
  if (data.frame.scene.showBounds) drawOutlines(data);
  gpu::barrier();
}

void SurfacePass::drawOutlines(const FrameData& data) {
  std::vector<Vertex> vertices;
  for (const auto& p : outlines(data.frame.scene, data.grid.worldFromTex))
    vertices.push_back({glm::vec3(p - sceneOrigin(data.grid)), glm::vec3(0.0f)});
  std::vector<std::uint32_t> indices(vertices.size());
  std::iota(indices.begin(), indices.end(), 0u);
  Vertices lines("outlines", vertices, indices);
  mProgram->set(0, glm::vec4(0.62f, 0.66f, 0.70f, 0.0f));
  mProgram->set(1, int(shared::kDataInstance));
  gpu::drawIndexed(*mProgram, lines.array, gpu::Primitive::Lines, {lines.count});
}

void SurfacePass::bindImages() const {
  mColor.bindImage(shared::kSurfaceColorImage, gpu::Access::Write);
  mAux.bindImage(shared::kSurfaceAuxImage, gpu::Access::ReadWrite);
  mIds.bindImage(shared::kSurfaceIdImage, gpu::Access::ReadWrite);
}

void SurfacePass::bind(const FrameData&) const {
  mColor.bindSampler(shared::kSurfaceColorUnit);
  mAux.bindSampler(shared::kSurfaceAuxUnit);
  mIds.bindSampler(shared::kSurfaceIdUnit);
}

}  // namespace velum::render
