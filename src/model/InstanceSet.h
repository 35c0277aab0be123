#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/Model.h"
#include "gpu/Buffer.h"
#include "gpu/Texture.h"
#include "model/Levels.h"

namespace velum::model {

/// Where a model lies in the scene frame: angstrom * scale - origin.
struct Placement {
  glm::dvec3 origin{0.0};
  double scale = 1.0;
  bool operator==(const Placement&) const = default;
};

/// A model on the GPU: its instances, molecules, levels and balls, stored once whatever the number of copies. GL
/// thread.
class InstanceSet {
 public:
  InstanceSet() = default;
  /// @throw gpu::GpuError when the driver has no memory for the model
  InstanceSet(const Model& model, const LevelSet& levels, const Placement& placement);
  /// Binds the rows for all shaders that include model/instances.glsl.
  void bind() const;
  int instanceCount() const { return mInstanceCount; }
  std::uint64_t bytes() const;

 private:
  struct Rows {
    gpu::Buffer buffer;
    gpu::Texture texels;
  };
  template <class T>
  static Rows rowsOf(const char* label, gpu::Format format, const std::vector<T>& values);

  int mInstanceCount = 0;
  Rows mInstances, mMolecules, mLevels, mBalls, mKinds;
  Rows mOrder, mBundles;  ///< Instances bundle by bundle, and the sphere around each bundle.
};

}  // namespace velum::model
