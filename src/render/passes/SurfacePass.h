#pragma once
#include <array>
#include <glm/glm.hpp>
#include <map>
#include <vector>

#include "velum/gpu/Buffer.h"
#include "velum/gpu/Framebuffer.h"
#include "velum/gpu/Program.h"
#include "velum/gpu/Texture.h"
#include "velum/scene/Scene.h"

namespace velum::render {

/// Opaque surfaces and outlines: colour, normal and distance along each pixel's ray, for the ray caster to stop at.
class SurfacePass {
 public:
  SurfacePass();
  /// Whether some cut is a membrane.
  void useMembranes(bool on);
  /// @param origin  the scene frame's origin, world mm
  /// @param bounds  the twelve edges of the data's box come from here: world from 0..1
  void draw(const scene::Scene& scene, glm::dvec3 origin, const glm::dmat4& worldFromTex, glm::ivec2 size);
  /// Binds its pictures; empty ones when the scene has no surface.
  void bind() const;
  void clear();

 private:
  struct Vertex {
    glm::vec4 position, normal;
  };
  void resize(glm::ivec2 size);
  const gpu::Buffer& meshBuffer(const Shared<Mesh>& mesh, glm::dvec3 origin);
  gpu::Program mProgram;
  bool mHasMembranes = false;
  gpu::Texture mColor, mAux, mDepth;
  gpu::Framebuffer mTarget;
  std::map<std::pair<std::uint64_t, std::array<double, 3>>, gpu::Buffer> mMeshes;
};

/// Line ends, in pairs, of the data's box and of each enabled cut. World mm.
std::vector<glm::dvec3> outlines(const scene::Scene& scene, const glm::dmat4& worldFromTex);

}  // namespace velum::render
