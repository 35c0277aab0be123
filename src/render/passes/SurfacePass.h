#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <span>

#include "gpu/Buffer.h"
#include "gpu/Framebuffer.h"
#include "gpu/Program.h"
#include "gpu/Texture.h"
#include "gpu/VertexArray.h"
#include "render/FrameData.h"
#include "render/passes/Pass.h"

namespace velum::render {

/// Opaque surfaces and outlines: colour, normal and distance along each pixel's ray, and which surface it is, for the
/// ray caster to stop at. Rasterised for each sample anew; the vertices on the GPU have the mesh and the scene frame's
/// origin and unit for a key.
class SurfacePass : public Pass {
 public:
  SurfacePass() : Pass("Surfaces") {}
  void prepare(FrameData& data) override;
  bool isReady() override { return mProgram->isReady(); }
  void addSteps(const FrameData& data, int sample, WorkQueue& queue) override;
  void bind(const FrameData& data) const override;
  /// For passes that draw more of what rays stop at, after this one's steps, which clear it: the outputs of
  /// surface.frag.
  const gpu::Framebuffer& target() const { return mTarget; }
  /// The same for dispatches: kSurfaceColorImage, kSurfaceAuxImage, kSurfaceIdImage. There is no depth for them.
  void bindImages() const;

 private:
  struct Vertex {
    glm::vec3 position, normal;
  };
  /// A mesh, or lines, as vertex attributes: storage blocks of a vertex shader are not promised, nor long ones of any.
  struct Vertices {
    Vertices() = default;
    Vertices(const char* label, std::span<const Vertex> vertices, std::span<const std::uint32_t> indices);
    gpu::Buffer vertices, indices;
    gpu::VertexArray array;
    int count = 0;  ///< Indices.
  };
  void resize(glm::ivec2 size);
  using MeshKey = std::pair<std::uint64_t, std::array<double, 4>>;  ///< Id, the scene frame's origin and unit.
  static MeshKey keyOf(const Shared<Mesh>& mesh, const FrameData& data);
  void forgetMeshes(const FrameData& data);
  const Vertices& verticesOf(const Shared<Mesh>& mesh, const FrameData& data);
  void draw(const FrameData& data);
  void drawOutlines(const FrameData& data);

  std::map<bool, gpu::Program> mPrograms;  ///< By whether some cut is a membrane.
  const gpu::Program* mProgram = nullptr;  ///< The frame's.
  gpu::Texture mColor, mAux, mIds, mDepth;
  gpu::Framebuffer mTarget;
  bool mIsBlank = false;  ///< Nothing is drawn in it.
  std::map<MeshKey, Vertices> mMeshes;
};

}  // namespace velum::render
