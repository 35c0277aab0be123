#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <string>

#include "core/Image.h"
#include "scene/Scene.h"

namespace velum::bench {

class Worker;

/// A scene of ours drawn by one of VTK's volume mappers: same data, points of the transfer function, camera, step,
/// light. VTK 9.1 of Debian opens its windows through X, so a display must be there.
class VtkScene {
 public:
  enum class Mapper { Gpu, Cpu };

  VtkScene(const scene::Scene& scene, Mapper mapper, glm::ivec2 size);
  ~VtkScene();

  /// Draws and waits. @return milliseconds
  double render(const scene::Camera& camera);
  /// The last picture: R, G, B, top row first.
  Image read();
  /// GL_RENDERER of VTK's window.
  std::string renderer();

 private:
  struct Impl;
  std::unique_ptr<Worker> mWorker;  ///< VTK's context lives on this thread.
  std::unique_ptr<Impl> mImpl;
};

/// True where VTK can open a window.
bool hasDisplay();

}  // namespace velum::bench
