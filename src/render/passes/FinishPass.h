#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gpu/Buffer.h"
#include "gpu/Program.h"
#include "gpu/Texture.h"
#include "render/FinishSetup.h"
#include "render/FrameData.h"
#include "render/Gbuffer.h"
#include "render/passes/Pass.h"
#include "render/passes/ProgramCache.h"
#include "shared/finish.h"

namespace velum::render {

/// The parts of a finish ([ACS] 4.4) that are computed from the samples of a frame: sums of the lit spheres' colours
/// and of edges, strokes along the form, and the paper. ResolvePass puts them into the picture. Costs nothing where the
/// finish is off.
class FinishPass : public Pass {
 public:
  explicit FinishPass(const Gbuffer& gbuffer);
  void prepare(FrameData& data) override;
  void addSteps(const FrameData& data, int sample, WorkQueue& queue) override;
  /// Begins the next picture: nothing of it is there yet.
  void restart() {
    mSamples = mRowsDone = 0;
    mIsAhead = false;
  }

  /// The programs of another one, see FrameWork::takePrograms().
  void takePrograms(FinishPass& other);

  /// How many samples are in the sums.
  int samples() const { return mSamples; }
  /// How many rows, from the top, have one sample more.
  int rowsDone() const { return mRowsDone; }
  /// Where no sample is complete, adds the part of the first sample that is there.
  void catchUp(const FrameData& data);
  /// Binds the results for the program that draws the picture.
  void bindResults() const;

 private:
  /// The lit spheres of a frame: all that are named, and the one that each structure has.
  struct Spheres {
    std::vector<std::string> names;
    std::vector<scene::LitSphere> own;
    std::vector<std::uint32_t> rowOf;  ///< By structure: row of its lit sphere; 0: none.
    bool operator==(const Spheres&) const = default;
  };
  /// Key of the paper.
  struct PaperKey {
    scene::Paper paper;
    glm::vec3 color;
    double grain, scale;
    Shared<Image> own;
    glm::ivec2 pictureSize, windowOrigin, windowSize;
    bool operator==(const PaperKey&) const = default;
  };
  static scene::DepthSteps stepsOf(const FrameData& data);
  static Spheres spheresOf(const scene::Scene& scene);
  void makeSpheres(const scene::Scene& scene);
  void makeGroups(const FrameData& data);
  void makeTargets(const FrameData& data);
  void addPaper(const FrameData& data, WorkQueue& queue);
  void drawPaper(const PaperKey& key);
  void addStrokes(const FrameData& data, WorkQueue& queue);
  void add(glm::ivec4 rect, bool isFirst);
  void runOverCells(const gpu::Program& program, const gpu::Texture& from, const gpu::Texture& to) const;
  glm::ivec4 rectOf(const FrameData& data) const;
  void bindInputs() const;

  const Gbuffer& mGbuffer;
  gpu::UniformBuffer<shared::FinishParams> mParams{"finish"};
  shared::FinishParams mValues{};
  gpu::Program mAdd, mAddModel, mTurns, mField, mAlign;  ///< Made when first needed.
  ProgramCache<scene::Paper> mPaperPrograms;
  Spheres mSpheres;
  gpu::Texture mSphereTexture, mRowOfTexture;
  gpu::Buffer mRowOf;
  std::vector<std::uint32_t> mGroups;  ///< By structure: one more than its compartment in a model that is seen alone;
                                       ///< empty: something else is seen.
  gpu::Buffer mGroupOf;
  gpu::Texture mGroupOfTexture;
  gpu::Texture mSums;  ///< Lit spheres' colours, premultiplied; edges.
  gpu::Texture mPaper, mOwnPaper;
  glm::ivec2 mPaperTurns{
      0};  ///< For the user's own paper: 1, across and down, where every other copy of the picture is mirrored.
  std::optional<PaperKey> mPaperKey;
  gpu::Texture mCells[2];  ///< Cells of strokes; the first texture holds the result.
  int mSamples = 0, mRowsDone = 0;
  bool mIsAhead = false;  ///< The sums hold a part of a sample that is not complete.
};

}  // namespace velum::render
