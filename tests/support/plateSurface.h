#pragma once
#include "scene/Scene.h"

namespace velum {

/// A square across y, about the y axis.
inline scene::Surface plateSurface(float halfEdge, float y) {
  Mesh mesh;
  mesh.positions = {
      {-halfEdge, y, -halfEdge}, {halfEdge, y, -halfEdge}, {halfEdge, y, halfEdge}, {-halfEdge, y, halfEdge}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  scene::Surface surface;
  surface.data = Shared<Mesh>(std::move(mesh));
  return surface;
}

}  // namespace velum
