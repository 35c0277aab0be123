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

/// Draws opaque surfaces and outlines, at which the ray caster stops: colour, normal and distance along each pixel's
/// ray, and which surface it is. They are rasterised anew for each sample; the key of the vertices on the GPU is the
/// mesh with the scene frame's origin and unit.
class SurfacePass : public Pass {
 public:
  SurfacePass() : Pass("Surfaces") {}
  void prepare(FrameData& data) override;
  bool isReady() override { return mProgram->isReady(); }
  void addSteps(const FrameData& data, int sample, WorkQueue& queue) override;
  void bind(const FrameData& data) const override;
  /// The programs of another one, see FrameWork::takePrograms().
  void takePrograms(SurfacePass& other) { mPrograms.swap(other.mPrograms); }
  /// The target, with the outputs of surface.frag, for passes that draw further things at which rays stop. They must
  /// draw after this pass's steps, which clear the target.
  const gpu::Framebuffer& target() const { return mTarget; }
  /// Binds the target's textures as images for dispatches: kSurfaceColorImage, kSurfaceAuxImage, kSurfaceIdImage. The
  /// depth is not bound.
  void bindImages() const;

 private:
  struct Vertex {
    glm::vec3 position, normal;
  };
  /// A mesh, or lines, as vertex attributes: OpenGL promises vertex shaders no storage blocks, and no shader long ones.
  struct Vertices {
    Vertices() = default;
    Vertices(const char* label, std::span<const Vertex> vertices, std::span<const std::uint32_t> indices);
    gpu::Buffer vertices, indices;
    gpu::VertexArray array;
    int count = 0;  ///< Indices.
  };
  void resize(glm::ivec2 size);
  using MeshKey = std::pair<std::uint64_t, std::array<double, 4>>;  ///< Mesh id, the scene frame's origin and unit.
  static MeshKey keyOf(const Shared<Mesh>& mesh, const FrameData& data);
  void forgetMeshes(const FrameData& data);
  const Vertices& verticesOf(const Shared<Mesh>& mesh, const FrameData& data);
  void draw(const FrameData& data);
  void drawOutlines(const FrameData& data);

  std::map<bool, gpu::Program> mPrograms;  ///< Key: whether some cut is a membrane.
  const gpu::Program* mProgram = nullptr;  ///< The program for the present frame.
  gpu::Texture mColor, mAux, mIds, mDepth;
  gpu::Framebuffer mTarget;
  bool mIsBlank = false;  ///< Nothing is drawn in the target.
  std::map<MeshKey, Vertices> mMeshes;
};

}  // namespace velum::render
