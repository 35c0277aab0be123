#include "render/passes/FinishPass.h"

#include <algorithm>
#include <cmath>

#include "render/WorkQueue.h"
#include "scene/Finishes.h"
#include "scene/LitSpheres.h"
#include "scene/PaperPicture.h"

namespace velum::render {

namespace {

constexpr int kPiecePixels = 1 << 20;  // a few milliseconds
constexpr double kStepVoxels = 2.5;    // noise moves surfaces by less
constexpr double kStepShare = 0.005;   // of the diameter of surfaces alone: as voxels of a scan of 500 would have it
constexpr int kMostSpheres = 96;       // in a texture that every driver takes; what comes after looks like the first
constexpr std::string_view kPlain = "porcelain";

gpu::Program make(std::string_view file) { return gpu::Program({file}, {{"FINISH", "1"}}); }

/// A frame's scene may name what there is not, or what could not be read.
std::string known(const scene::Finish& finish, const std::string& name) {
  const scene::LitSphere* own = scene::ownLitSphere(finish, name);
  bool isThere = own ? bool(own->data) : scene::isLitSphere(finish, name);
  return isThere ? name : std::string(kPlain);
}

std::vector<glm::u8vec4> texelsOf(const Image& image) {
  std::vector<glm::u8vec4> texels;
  for (std::size_t i = 0; i + 2 < image.pixels.size(); i += 3) {
    glm::vec3 color(image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]);
    texels.emplace_back(glm::u8vec3(color * 255.0f + 0.5f), std::uint8_t(255));
  }
  return texels;
}

gpu::Texture textureOf(const Image& paper) {
  glm::ivec2 size(paper.width, paper.height);
  auto texture =
      gpu::Texture::make2d("own paper", gpu::Format::Rgba8, size, gpu::Filter::Linear, gpu::levelCountOf({size, 1}));
  texture.write({0, 0, 0}, {size, 1}, texelsOf(paper).data());
  texture.generateLevels();
  return texture;
}

}  // namespace

FinishPass::FinishPass(const Gbuffer& gbuffer) : Pass("Finish"), mGbuffer(gbuffer) {}

void FinishPass::takePrograms(FinishPass& other) {
  for (auto program :
       {&FinishPass::mAdd, &FinishPass::mAddModel, &FinishPass::mTurns, &FinishPass::mField, &FinishPass::mAlign})
    std::swap(this->*program, other.*program);
  std::swap(mPaperPrograms, other.mPaperPrograms);
}

FinishPass::Spheres FinishPass::spheresOf(const scene::Scene& scene) {
  Spheres spheres;
  spheres.own = scene.finish.spheres;
  auto rowOf = [&](const std::string& wanted) {
    std::string name = known(scene.finish, wanted);
    auto found = std::find(spheres.names.begin(), spheres.names.end(), name);
    if (found == spheres.names.end() && spheres.names.size() >= kMostSpheres) return std::uint32_t(0);
    auto row = std::uint32_t(found - spheres.names.begin());
    if (found == spheres.names.end()) spheres.names.push_back(name);
    return row;
  };
  rowOf(scene.finish.sphere);
  int largest = 0;
  auto hasOwn = [&](const scene::Structure& structure) {
    return scene.finish.structureSpheres && !structure.litSphere.empty();
  };
  for (const auto& structure : scene.labels.structures)
    if (hasOwn(structure)) largest = std::max(largest, structure.id);
  spheres.rowOf.resize(std::size_t(largest) + 2);
  for (const auto& structure : scene.labels.structures)
    if (hasOwn(structure)) spheres.rowOf[std::size_t(structure.id)] = rowOf(structure.litSphere);
  return spheres;
}

void FinishPass::makeSpheres(const scene::Scene& scene) {
  Spheres spheres = spheresOf(scene);
  if (mSphereTexture && spheres == mSpheres) return;
  constexpr int kEdge = shared::kSphereTexels;
  static_assert(kEdge == scene::kLitSphereSize);
  mSphereTexture = gpu::Texture::make2d("lit spheres", gpu::Format::Rgba8, {kEdge, kEdge * int(spheres.names.size())},
                                        gpu::Filter::Linear);
  for (std::size_t row = 0; row < spheres.names.size(); ++row) {
    const scene::LitSphere* own = scene::ownLitSphere(scene.finish, spheres.names[row]);
    auto texels = texelsOf(own ? *own->data : scene::makeLitSphere(spheres.names[row]));
    mSphereTexture.write({0, int(row) * kEdge, 0}, {kEdge, kEdge, 1}, texels.data());
  }
  mRowOf = gpu::Buffer("lit spheres of structures", std::span<const std::uint32_t>(spheres.rowOf));
  mRowOfTexture = gpu::Texture::makeOfBuffer("lit spheres of structures", gpu::Format::R32ui, mRowOf);
  mSpheres = std::move(spheres);
}

/// The compartments of a model that is all that is seen.
void FinishPass::makeGroups(const FrameData& data) {
  std::vector<std::uint32_t> groups;
  if (scene::drawsModelAlone(data.frame.scene)) {
    groups.resize(data.structures.size());
    for (const MoleculeType& type : data.frame.scene.model.data->types) groups.push_back(type.compartment + 1);
  }
  if (groups == mGroups) return;
  mGroups = std::move(groups);
  if (mGroups.empty()) return;
  mGroupOf = gpu::Buffer("compartments of types", std::span<const std::uint32_t>(mGroups));
  mGroupOfTexture = gpu::Texture::makeOfBuffer("compartments of types", gpu::Format::R32ui, mGroupOf);
}

scene::DepthSteps FinishPass::stepsOf(const FrameData& data) {
  if (scene::drawsModelAlone(data.frame.scene)) {
    scene::DepthSteps steps = scene::modelDepthSteps(data.frame.scene.model);
    return {steps.least * angstromOf(data), steps.deep * angstromOf(data)};
  }
  bool hasVoxels = data.volume || data.labelUse != LabelUse::None;
  return {hasVoxels ? kStepVoxels / double(data.params.voxelsPerLength) : kStepShare * diameterOf(data.grid), 0.0};
}

void FinishPass::prepare(FrameData& data) {
  const scene::Finish& finish = data.frame.scene.finish;
  if (!needsSamples(finish)) mSums = {};
  if (!scene::addsAnything(finish)) return;
  if (needsSamples(finish)) makeSpheres(data.frame.scene);
  mValues =
      makeFinishParams(data.frame, mSphereTexture ? mSphereTexture.size().y / shared::kSphereTexels : 1, stepsOf(data));
  makeGroups(data);
  mParams.set(mValues);
  makeTargets(data);
}

void FinishPass::makeTargets(const FrameData& data) {
  const scene::Finish& finish = data.frame.scene.finish;
  glm::ivec2 size = data.frame.windowSize;
  if (needsSamples(finish)) {
    if (!mSums || glm::ivec2(mSums.size()) != size) mSums = gpu::Texture::make2d("finish", gpu::Format::Rgba32f, size);
    if (mGroups.empty() && !mAdd) mAdd = make("render/finish.comp");
    if (!mGroups.empty() && !mAddModel)
      mAddModel = gpu::Program({"render/finish.comp"}, {{"FINISH", "1"}, {"MODEL", "1"}});
  }
  if (finish.hatching > 0) {
    glm::ivec2 cells(mValues.cellsX, mValues.cellsY);
    for (gpu::Texture& texture : mCells)
      if (!texture || glm::ivec2(texture.size()) != cells)
        texture = gpu::Texture::make2d("strokes", gpu::Format::Rgba32f, cells);
    if (!mTurns) mTurns = make("render/stroke_turns.comp");
    if (!mField) mField = make("render/stroke_field.comp");
    if (!mAlign) mAlign = make("render/stroke_align.comp");
  }
}

void FinishPass::addSteps(const FrameData& data, int sample, WorkQueue& queue) {
  const scene::Finish& finish = data.frame.scene.finish;
  if (sample == 0 && finish.paper != scene::Paper::None) addPaper(data, queue);
  if (!needsSamples(finish)) return;
  glm::ivec4 all = rectOf(data);
  if (sample == 0)
    queue.add(*this, [this] {
      restart();
      mSums.clear();
    });
  int rows = std::max(1, kPiecePixels / std::max(1, all.z));
  for (int y = 0; y < all.w; y += rows) {
    glm::ivec4 rect(all.x, all.y + y, all.z, std::min(rows, all.w - y));
    queue.add(*this, [this, rect, isFirst = sample == 0] {
      add(rect, isFirst);
      mRowsDone = rect.y + rect.w;
    });
  }
  // Strokes stay where the first sample has them: a mean of several would be grey.
  if (sample == 0 && finish.hatching > 0) addStrokes(data, queue);
  queue.add(*this, [this, sample] {
    mSamples = sample + 1;
    mRowsDone = 0;
  });
}

/// What rays may have changed, and as far around as lines go.
glm::ivec4 FinishPass::rectOf(const FrameData& data) const {
  glm::ivec2 size = data.frame.windowSize;
  glm::ivec4 covered = drawnRect(data);
  int reach = lineMargin(data.frame);
  glm::ivec2 from = glm::max(glm::ivec2(covered) - reach, glm::ivec2(0));
  glm::ivec2 to = glm::min(glm::ivec2(covered.x + covered.z, covered.y + covered.w) + reach, size);
  return {from, glm::max(to - from, glm::ivec2(0))};
}

void FinishPass::bindInputs() const {
  mParams.bind(shared::kFinishBinding);
  mGbuffer.bindSample();
  mSphereTexture.bindSampler(shared::kLitSphereUnit);
  mRowOfTexture.bindSampler(shared::kSphereOfUnit);
}

void FinishPass::add(glm::ivec4 rect, bool isFirst) {
  bindInputs();
  mSums.bindImage(shared::kFinishImage, gpu::Access::ReadWrite);
  const gpu::Program& program = mGroups.empty() ? mAdd : mAddModel;
  program.set(0, rect);
  program.set(1, isFirst ? 1 : 0);
  if (!mGroups.empty()) mGroupOfTexture.bindSampler(shared::kGroupOfUnit);
  gpu::dispatch(program, {(rect.z + 7) / 8, (rect.w + 7) / 8, 1});
  gpu::barrier();
}

void FinishPass::catchUp(const FrameData& data) {
  bool hasSums = mSamples > 0 || (mRowsDone > 0 && !mIsAhead);
  if (hasSums || !needsSamples(data.frame.scene.finish)) return;
  mSums.clear();
  add(rectOf(data), true);
  mIsAhead = true;
  mRowsDone = data.frame.windowSize.y;
}

void FinishPass::addPaper(const FrameData& data, WorkQueue& queue) {
  const Frame& frame = data.frame;
  const scene::Finish& finish = frame.scene.finish;
  PaperKey key{finish.paper, finish.paperColor, finish.paperGrain,  finish.paperScale,
               {},           frame.pictureSize, frame.windowOrigin, frame.windowSize};
  if (finish.paper == scene::Paper::Own) {
    key.own = finish.ownPaper.data;
    if (!key.own) key.paper = scene::Paper::Smooth;  // could not be read
  }
  if (mPaperKey == key) return;
  queue.add(*this, [this, key] {
    drawPaper(key);
    mPaperKey = key;
  });
}

void FinishPass::drawPaper(const PaperKey& key) {
  const gpu::Program& program =
      mPaperPrograms.find(key.paper, [&] { return gpu::Program({"render/paper.comp"}, definesOf(key.paper)); });
  if (!mPaper || glm::ivec2(mPaper.size()) != key.windowSize)
    mPaper = gpu::Texture::make2d("paper", gpu::Format::Rgba8, key.windowSize);
  if (key.own) {
    if (!mOwnPaper || !mPaperKey || !(mPaperKey->own == key.own)) {
      mOwnPaper = textureOf(*key.own);
      mPaperTurns = 1 - glm::ivec2(scene::tilesOf(*key.own));
    }
    mOwnPaper.bindSampler(shared::kOwnPaperUnit);
    program.set(1, mPaperTurns);
  }
  mParams.bind(shared::kFinishBinding);
  mPaper.bindImage(shared::kPaperImage, gpu::Access::Write);
  program.set(0, key.windowOrigin);
  gpu::dispatch(program, {(key.windowSize.x + 7) / 8, (key.windowSize.y + 7) / 8, 1});
  gpu::barrier();
}

void FinishPass::runOverCells(const gpu::Program& program, const gpu::Texture& from, const gpu::Texture& to) const {
  mParams.bind(shared::kFinishBinding);
  from.bindSampler(shared::kStrokeUnit);
  to.bindImage(shared::kStrokeImage, gpu::Access::Write);
  gpu::dispatch(program, {(mValues.cellsX + 7) / 8, (mValues.cellsY + 7) / 8, 1});
  gpu::barrier();
}

void FinishPass::addStrokes(const FrameData& data, WorkQueue& queue) {
  queue.add(*this, [this, &data] {
    mGbuffer.bindSample();
    mTurns.set(0, data.frame.windowOrigin);
    runOverCells(mTurns, mCells[0], mCells[1]);
    runOverCells(mField, mCells[1], mCells[0]);
    static_assert(kStrokeSteps % 2 == 0, "what comes out is to lie in the first");
    for (int step = 0; step < kStrokeSteps; ++step) runOverCells(mAlign, mCells[step % 2], mCells[1 - step % 2]);
  });
}

void FinishPass::bindResults() const {
  mParams.bind(shared::kFinishBinding);
  if (mSums) mSums.bindImage(shared::kFinishImage, gpu::Access::Read);
  if (mPaper) mPaper.bindSampler(shared::kPaperUnit);
  if (mCells[0]) mCells[0].bindSampler(shared::kStrokeUnit);
}

}  // namespace velum::render
