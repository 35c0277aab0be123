#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gpu/Buffer.h"
#include "gpu/Program.h"
#include "gpu/Texture.h"
#include "render/FrameData.h"
#include "render/Gbuffer.h"
#include "render/passes/Pass.h"
#include "render/passes/ProgramCache.h"
#include "shared/finish.h"

namespace velum::render {

/// What an illustrator adds ([ACS] 4.4), as far as it is worked out from the samples of a frame: sums of the lit
/// spheres' colours and of edges, strokes along the form, and the paper. ResolvePass puts it into the picture. Costs
/// nothing where the finish is off.
class FinishPass : public Pass {
 public:
  explicit FinishPass(const Gbuffer& gbuffer);
  void prepare(FrameData& data) override;
  void addSteps(const FrameData& data, int sample, WorkQueue& queue) override;
  /// Nothing of the next picture is there yet.
  void restart() {
    mSamples = mRowsDone = 0;
    mIsAhead = false;
  }

  /// Samples that the sums are of.
  int samples() const { return mSamples; }
  /// Rows from the top that have one more.
  int rowsDone() const { return mRowsDone; }
  /// Where no sample is complete, takes what there is of the first.
  void catchUp(const FrameData& data);
  /// For the program that draws the picture.
  void bindResults() const;

 private:
  /// The lit spheres of a frame: those that are named, and which one each structure has.
  struct Spheres {
    std::vector<std::string> names;
    std::vector<scene::LitSphere> own;
    std::vector<std::uint32_t> rowOf;  ///< By structure; 0: none.
    bool operator==(const Spheres&) const = default;
  };
  /// Of the paper.
  struct PaperKey {
    scene::Paper paper;
    glm::vec3 color;
    double grain, scale;
    Shared<Image> own;
    glm::ivec2 pictureSize, windowOrigin, windowSize;
    bool operator==(const PaperKey&) const = default;
  };
  static double stepLengthOf(const FrameData& data);
  static Spheres spheresOf(const scene::Scene& scene);
  void makeSpheres(const scene::Scene& scene);
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
  gpu::Program mAdd, mTurns, mField, mAlign;  ///< Made when first asked for.
  ProgramCache<scene::Paper> mPaperPrograms;
  Spheres mSpheres;
  gpu::Texture mSphereTexture, mRowOfTexture;
  gpu::Buffer mRowOf;
  gpu::Texture mSums;  ///< Lit spheres' colours, premultiplied; edges.
  gpu::Texture mPaper, mOwnPaper;
  glm::ivec2 mPaperTurns{0};  ///< Of the user's own: 1 across, down, where every other one is turned over.
  std::optional<PaperKey> mPaperKey;
  gpu::Texture mCells[2];  ///< Of strokes; the first holds what comes out.
  int mSamples = 0, mRowsDone = 0;
  bool mIsAhead = false;  ///< The sums are of a sample that is not complete.
};

}  // namespace velum::render
