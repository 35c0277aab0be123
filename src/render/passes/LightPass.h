#pragma once
#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "gpu/Program.h"
#include "gpu/Texture.h"
#include "render/FrameData.h"
#include "render/passes/Pass.h"
#include "render/passes/ProgramCache.h"

namespace velum::render {

/// The light grid: how much key light reaches each place and how open its surroundings are, computed once for a scene
/// and a direction of the light, then looked up once a shaded sample. Material that is cut away or hidden does not
/// count. Cost: the grid's cells (at most 96^3 with software drivers, none smaller than half a voxel), not voxels or
/// pixels. Works on some layers at a time.
///
/// Previews keep the light where it stood in the world when the grid was made; without a grid of the same material they
/// have no shadows and occlusion.
class LightPass : public Pass {
 public:
  LightPass() : Pass("Light") {}
  void prepare(FrameData& data) override;
  void compile(const FrameData& data) override;
  bool isReady() override;
  void addSteps(const FrameData& data, int sample, WorkQueue& queue) override;
  void bind(const FrameData& data) const override;
  /// The programs of another one, see FrameWork::takePrograms().
  void takePrograms(LightPass& other) {
    std::swap(mExtinctionPrograms, other.mExtinctionPrograms);
    std::swap(mLightProgram, other.mLightProgram);
    std::swap(mMeansProgram, other.mMeansProgram);
  }

 private:
  /// A cut as far as it matters to the light: the words of its CutData without its look. A new member of CutData counts
  /// unless it is taken out here.
  using CutWords = std::array<std::uint32_t, sizeof(shared::CutData) / 4>;
  static CutWords wordsOf(shared::CutData cut);
  /// The material that the light has to pass through.
  struct Key {
    DataVariant variant;
    std::uint32_t flags = 0;
    VolumeKey volume;
    LabelKey labels;
    glm::mat4 sceneFromTex{1.0f}, labelFromScene{1.0f};
    glm::ivec3 cells{0};
    std::vector<CutWords> cuts;
    SheetSources sheets;
    std::vector<float> opacities;  ///< Opacity of each structure.
    SpareTable spares;
    std::vector<std::uint32_t> extinctionSums;
    float extinctionUnit = 0, tablePerTexel = 0, tableOffset = 0, isoValue = 0, unlabelledOpacity = 0;
    float voxelsPerLength = 0;
    bool operator==(const Key&) const = default;
  };
  static Key keyOf(const FrameData& data, glm::ivec3 cells);
  /// The light, and what is computed from it.
  struct Light {
    glm::vec3 direction{0.0f};
    bool isShadowed = false, isOccluded = false;
    double radius = 0;
  };
  static Light lightOf(const FrameData& data);
  void resize(const FrameData& data);
  void addExtinctionSteps(WorkQueue& queue);
  void addLightSteps(const FrameData& data, bool keepsOpenness, WorkQueue& queue);

  ProgramCache<DataVariant> mExtinctionPrograms;
  gpu::Program mLightProgram, mMeansProgram;
  const gpu::Program* mExtinctionProgram = nullptr;  ///< The program for the present frame.
  gpu::Texture mExtinction, mLight;
  glm::ivec3 mSize{0};
  double mCell = 1;            ///< Edge of a cell.
  std::optional<Key> mKey;     ///< Key of mExtinction, and of mLight where that is complete.
  std::optional<Light> mLit;   ///< The light that mLight was made for; nothing while mLight is being made.
  std::optional<Light> mOpen;  ///< The light that the openness in mLight was made for.
};

}  // namespace velum::render
