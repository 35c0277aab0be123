#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/Model.h"
#include "gpu/Buffer.h"
#include "gpu/Texture.h"
#include "model/Levels.h"

namespace velum::shared {
struct MoleculeRow;
struct LevelRow;
}  // namespace velum::shared

namespace velum::model {

struct WholeModel;

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
  /// @param hasWhole  the whole model is a molecule, too: the last one
  InstanceSet(const Model& model, const LevelSet& levels, const Placement& placement, bool hasWhole = false);
  /// Binds the rows for all shaders that include model/instances.glsl.
  void bind() const;
  int instanceCount() const { return mInstanceCount; }
  /// The whole model as a molecule of the first copy, in the scene frame.
  struct Whole {
    int molecule = 0;
    glm::vec4 sphere{0.0f};  ///< around the balls of all levels
    float error = 0.0f;      ///< of the finest level
  };
  const Whole& whole() const { return mWhole; }
  std::uint64_t bytes() const;

 private:
  struct Rows {
    gpu::Buffer buffer;
    gpu::Texture texels;
  };
  template <class T>
  static Rows rowsOf(const char* label, gpu::Format format, const std::vector<T>& values);

  /// What the rows are made of while they are made.
  struct Tables {
    std::vector<shared::MoleculeRow>& molecules;
    std::vector<shared::LevelRow>& levels;
    std::vector<glm::vec4>& balls;
    std::vector<glm::u8vec2>& kinds;
  };
  void addWhole(const WholeModel& whole, const Model& model, const Placement& placement, Tables to);

  int mInstanceCount = 0;
  Whole mWhole;
  Rows mInstances, mMolecules, mLevels, mBalls, mKinds;
  Rows mOrder, mBundles;  ///< Instances bundle by bundle, and the sphere around each bundle.
};

}  // namespace velum::model
