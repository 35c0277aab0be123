#include "SurfacePass.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "shared/frame.h"
#include "velum/gpu/Draw.h"

namespace velum::render {

namespace {

void addLine(std::vector<glm::dvec3>& lines, glm::dvec3 a, glm::dvec3 b) {
  lines.push_back(a);
  lines.push_back(b);
}

void addBox(std::vector<glm::dvec3>& lines, const glm::dmat4& worldFromUnit) {
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 4; ++side) {
      glm::dvec3 a(0.0);
      a[(axis + 1) % 3] = side & 1;
      a[(axis + 2) % 3] = side >> 1;
      glm::dvec3 b = a;
      b[axis] = 1.0;
      addLine(lines, glm::dvec3(worldFromUnit * glm::dvec4(a, 1)), glm::dvec3(worldFromUnit * glm::dvec4(b, 1)));
    }
}

void addCircle(std::vector<glm::dvec3>& lines, const glm::dmat4& frame, glm::dvec3 centre, glm::dvec3 x, glm::dvec3 y) {
  constexpr int kSides = 64;
  auto at = [&](int i) {
    double angle = 2.0 * 3.14159265358979 * i / kSides;
    return glm::dvec3(frame * glm::dvec4(centre + std::cos(angle) * x + std::sin(angle) * y, 1.0));
  };
  for (int i = 0; i < kSides; ++i) addLine(lines, at(i), at(i + 1));
}

/// The polygon in which a plane meets the data's box, as its edges.
void addPlane(std::vector<glm::dvec3>& lines, const scene::Cut& cut, const glm::dmat4& worldFromTex) {
  std::vector<glm::dvec3> edges;
  addBox(edges, worldFromTex);
  glm::dmat4 frame = scene::worldFromCut(cut);
  glm::dvec3 normal(frame[2]), x(frame[0]), y(frame[1]);
  std::vector<glm::dvec3> corners;
  for (std::size_t i = 0; i < edges.size(); i += 2) {
    double a = glm::dot(edges[i] - cut.centreMm, normal), b = glm::dot(edges[i + 1] - cut.centreMm, normal);
    if ((a < 0) != (b < 0)) corners.push_back(glm::mix(edges[i], edges[i + 1], a / (a - b)));
  }
  if (corners.size() < 3) return;
  glm::dvec3 middle(0.0);
  for (auto& c : corners) middle += c / double(corners.size());
  auto angle = [&](glm::dvec3 c) { return std::atan2(glm::dot(c - middle, y), glm::dot(c - middle, x)); };
  std::sort(corners.begin(), corners.end(), [&](auto a, auto b) { return angle(a) < angle(b); });
  for (std::size_t i = 0; i < corners.size(); ++i) addLine(lines, corners[i], corners[(i + 1) % corners.size()]);
}

void addCut(std::vector<glm::dvec3>& lines, const scene::Cut& cut, const glm::dmat4& worldFromTex) {
  glm::dmat4 frame = scene::worldFromCut(cut);
  glm::dvec3 half = cut.sizeMm * 0.5;
  glm::dvec3 x(half.x, 0, 0), y(0, half.x, 0), z(0, 0, half.z);
  switch (cut.shape) {
    case scene::CutShape::Plane:
      addPlane(lines, cut, worldFromTex);
      break;
    case scene::CutShape::Membrane: {
      glm::dvec3 across(0, half.y, 0), corners[] = {-x - across, x - across, x + across, across - x};
      for (int i = 0; i < 4; ++i)
        addLine(lines, glm::dvec3(frame * glm::dvec4(corners[i], 1)),
                glm::dvec3(frame * glm::dvec4(corners[(i + 1) % 4], 1)));
      break;
    }
    case scene::CutShape::Box: {
      glm::dmat4 unit(1.0);
      for (int i = 0; i < 3; ++i) unit[i][i] = cut.sizeMm[i], unit[3][i] = -half[i];
      addBox(lines, frame * unit);
      break;
    }
    case scene::CutShape::Sphere:
      addCircle(lines, frame, {}, x, y);
      addCircle(lines, frame, {}, x, {0, 0, half.x});
      addCircle(lines, frame, {}, y, {0, 0, half.x});
      break;
    case scene::CutShape::Cylinder:
    case scene::CutShape::Cone: {
      bool cone = cut.shape == scene::CutShape::Cone;
      glm::dvec3 top = cone ? 2.0 * z : z, bottom = cone ? glm::dvec3(0.0) : -z;
      addCircle(lines, frame, top, x, y);
      if (!cone) addCircle(lines, frame, bottom, x, y);
      for (auto side : {x, -x, y, -y})
        addLine(lines, glm::dvec3(frame * glm::dvec4(top + side, 1)),
                glm::dvec3(frame * glm::dvec4(cone ? bottom : bottom + side, 1)));
      break;
    }
  }
}

}  // namespace

std::vector<glm::dvec3> outlines(const scene::Scene& scene, const glm::dmat4& worldFromTex) {
  std::vector<glm::dvec3> lines;
  addBox(lines, worldFromTex);
  for (const auto& cut : scene.cuts)
    if (cut.enabled) addCut(lines, cut, worldFromTex);
  return lines;
}

SurfacePass::SurfacePass() : mProgram({"render/surface.vert", "render/surface.frag"}) { resize({1, 1}); }

void SurfacePass::useMembranes(bool on) {
  if (on == mHasMembranes) return;
  mHasMembranes = on;
  mProgram = gpu::Program({"render/surface.vert", "render/surface.frag"},
                          on ? gpu::Defines{{"MEMBRANES", "1"}} : gpu::Defines{});
}

void SurfacePass::resize(glm::ivec2 size) {
  if (mColor && glm::ivec2(mColor.size()) == size) return;
  mColor = gpu::Texture::make2d("surface colour", gpu::Format::Rgba16f, size);
  mAux = gpu::Texture::make2d("surface normal, distance", gpu::Format::Rgba32f, size);
  mDepth = gpu::Texture::make2d("surface depth", gpu::Format::Depth32f, size);
  mTarget = gpu::Framebuffer("surfaces", {&mColor, &mAux}, &mDepth);
  mTarget.clear(glm::vec4(0.0f), 1.0f);
}

const gpu::Buffer& SurfacePass::meshBuffer(const Shared<Mesh>& mesh, glm::dvec3 origin) {
  auto& buffer = mMeshes[{mesh.id(), {origin.x, origin.y, origin.z}}];
  if (buffer) return buffer;
  std::vector<Vertex> vertices;
  vertices.reserve(mesh->indices.size());
  for (auto index : mesh->indices) {
    glm::vec3 normal = index < mesh->normals.size() ? mesh->normals[index] : glm::vec3(0.0f);
    vertices.push_back(
        {glm::vec4(glm::vec3(glm::dvec3(mesh->positions[index]) - origin), 1.0f), glm::vec4(normal, 0.0f)});
  }
  buffer = gpu::Buffer("mesh", std::span<const Vertex>(vertices));
  return buffer;
}

void SurfacePass::draw(const scene::Scene& scene, glm::dvec3 origin, const glm::dmat4& worldFromTex, glm::ivec2 size) {
  bool any = scene.showBounds;
  for (const auto& surface : scene.surfaces) any = any || (surface.visible && surface.data);
  resize(any ? size : glm::ivec2(1));
  mTarget.clear(glm::vec4(0.0f), 1.0f);
  if (!any) return;
  mTarget.bind();
  for (const auto& surface : scene.surfaces) {
    if (!surface.visible || !surface.data) continue;
    meshBuffer(surface.data, origin).bindStorage(shared::kMeshBinding);
    mProgram.set(0, glm::vec4(surface.color, 1.0f));
    gpu::draw(mProgram, gpu::Primitive::Triangles, {int(surface.data->indices.size())});
  }
  if (scene.showBounds) {
    std::vector<Vertex> vertices;
    for (const auto& p : outlines(scene, worldFromTex))
      vertices.push_back({glm::vec4(glm::vec3(p - origin), 1.0f), glm::vec4(0.0f)});
    gpu::Buffer lines("outlines", std::span<const Vertex>(vertices));
    lines.bindStorage(shared::kMeshBinding);
    mProgram.set(0, glm::vec4(0.62f, 0.66f, 0.70f, 0.0f));
    gpu::draw(mProgram, gpu::Primitive::Lines, {int(vertices.size())});
  }
  gpu::barrier();
}

void SurfacePass::bind() const {
  mColor.bindSampler(shared::kSurfaceColorUnit);
  mAux.bindSampler(shared::kSurfaceAuxUnit);
}

void SurfacePass::clear() { mMeshes.clear(); }

}  // namespace velum::render
