#include "render/passes/UploadPass.h"

#include <algorithm>

#include "core/Vectors.h"
#include "render/WorkQueue.h"

namespace velum::render {

namespace {

constexpr int kQuickTexels = 96;  // along the longest side: under 30 ms on two cores

LabelUse labelUseOf(const scene::Scene& scene) {
  if (!scene.labels.data || !scene.labels.visible) return LabelUse::None;
  return scene.volume.data && scene.volume.visible ? LabelUse::OverVolume : LabelUse::Alone;
}

/// Labels over a volume that is streamed may be as fine as its finest level.
bool hasLabelBricks(const scene::Scene& scene) {
  return labelUseOf(scene) == LabelUse::OverVolume && scene.volume.data->finer;
}

VolumeKey drawnVolumeKey(const Frame& frame) {
  VolumeKey key = volumeKeyOf(frame.scene.volume);
  if (key.id != 0 && frame.scene.volume.data->finer) key.brickBytes = frame.brickBytes;
  return key;
}

/// The grid that stands for a frame's data.
FrameGrid gridOf(const FrameData& data) {
  const scene::Scene& scene = data.frame.scene;
  FrameGrid grid;
  if (const GpuVolume* volume = data.volume)
    return {volume->dims,       volume->cells,       volume->worldFromTex,
            volume->valueScale, volume->valueOffset, volume->gradientScale};
  if (data.labelUse == LabelUse::Alone) {
    grid.dims = scene.labels.data->dims();
    grid.cells = cellGridFor(grid.dims);
    glm::dmat4 voxelFromTex(1.0);
    for (int axis = 0; axis < 3; ++axis) voxelFromTex[axis][axis] = grid.dims[axis], voxelFromTex[3][axis] = -0.5;
    grid.worldFromTex = scene.labels.data->worldFromVoxel() * voxelFromTex;
    return grid;
  }
  grid.cells = {4, glm::ivec3(1)};
  scene::Bounds bounds = scene::computeBounds(scene);
  glm::dvec3 edges = solidEdges(bounds.max - bounds.min);
  for (int axis = 0; axis < 3; ++axis) {
    grid.worldFromTex[axis][axis] = edges[axis];
    grid.worldFromTex[3][axis] = bounds.min[axis];
  }
  return grid;
}

}  // namespace

const UploadPass::Uploaded* UploadPass::drawnFor(const FrameData& data) const {
  VolumeKey key = drawnVolumeKey(data.frame);
  if (key.id == 0) return nullptr;
  if (mWhole && mWhole->key == key) return &*mWhole;
  key.isQuick = true;
  return mQuick && mQuick->key == key ? &*mQuick : nullptr;
}

/// What is not needed any more goes before anything new comes.
void UploadPass::startWhole(const scene::VolumeLayer& layer, const VolumeKey& key) {
  mWhole.reset();
  mUpload.reset();
  mStreamed.reset();
  if (layer.data->finer)
    mStreamed = std::make_unique<Residency>(layer, mLimits, key.brickBytes);
  else
    mUpload = std::make_unique<VolumeUpload>(layer, mLimits);
  mUploadKey = key;
}

bool UploadPass::stepWhole() {
  if (mStreamed ? !mStreamed->step() : !mUpload->step()) return false;
  mWhole = Uploaded{mUploadKey, mUpload ? mUpload->take() : GpuVolume{}, std::move(mStreamed)};
  mUpload.reset();
  return true;
}

void UploadPass::prepare(FrameData& data) {
  mMsBefore = mMs;
  LabelUse labels = labelUseOf(data.frame.scene);
  if (hasLabelBricks(data.frame.scene))
    mBricks.begin(data.frame.scene, false);
  else if (labels != LabelUse::None)
    mShares.begin(data.frame.scene, labels == LabelUse::Alone);
  const auto& layer = data.frame.scene.volume;
  VolumeKey key = drawnVolumeKey(data.frame);
  if (key.id == 0 || (mWhole && mWhole->key == key)) return;
  if (data.frame.isPreview) {
    if (!drawnFor(data)) mQuick.reset();
    return;
  }
  if (!(mUpload || mStreamed) || !(mUploadKey == key)) startWhole(layer, key);
  mMs = mMsBefore = 0;
}

void UploadPass::addSteps(const FrameData& data, int, WorkQueue& queue) {
  if (hasLabelBricks(data.frame.scene))
    queue.addUntilDone(*this, [this] { return mBricks.step(); });
  else if (labelUseOf(data.frame.scene) != LabelUse::None)
    queue.addUntilDone(*this, [this] { return mShares.step(); });
  VolumeKey key = drawnVolumeKey(data.frame);
  if (key.id == 0 || (mWhole && mWhole->key == key)) return;
  if (!data.frame.isPreview) {
    queue.addUntilDone(*this, [this] { return stepWhole(); });
    return;
  }
  if (mQuick) return;
  key.isQuick = true;
  queue.add(*this, [this, &data, key] {
    VolumeUpload copy(data.frame.scene.volume, mLimits, kQuickTexels);
    while (!copy.step()) {
    }
    mQuick = Uploaded{key, copy.take(), nullptr};
  });
}

void UploadPass::complete(FrameData& data) {
  const Uploaded* drawn = drawnFor(data);
  data.residency = drawn ? drawn->residency.get() : nullptr;
  if (data.residency) data.residency->look(data.frame);
  data.volume = data.residency ? &data.residency->volume() : drawn ? &drawn->volume : nullptr;
  data.volumeKey = drawn ? drawn->key : VolumeKey{};
  data.labelUse = labelUseOf(data.frame.scene);
  data.grid = gridOf(data);
  data.hasLabelBricks = hasLabelBricks(data.frame.scene);
  if (data.labelUse != LabelUse::None) {
    const LabelVolume& labels = data.hasLabelBricks ? mBricks.labels() : *data.frame.scene.labels.data;
    data.grid.labelDims = labels.dims();
    data.grid.worldFromLabel = labels.worldFromVoxel();
  }
  mLabelBytes = 0;
  if (data.labelUse != LabelUse::None) {
    data.labelKey = {data.frame.scene.labels.data.id(), {data.grid.cells, data.grid.dims, data.grid.worldFromTex}};
    mLabels.update(data.frame.scene.labels.data, data.labelKey.over, !data.hasLabelBricks);
    mLabelBytes = data.hasLabelBricks ? mBricks.bytesSent() : mLabels.bytesSent();
    data.labelCells = &mLabels.cells();
    data.labelCellsRevision = mLabels.cellsRevision();
    data.sets = data.hasLabelBricks ? mBricks.sets() : mShares.sets();
  }
  mSheets.prepare(data.frame);
  data.sheetPlans = mSheets.plans();
  data.sheetSources = mSheets.sources();
  if (mNoVolume) return;
  mNoVolume = gpu::Texture::make3d("no volume", gpu::Format::R8, glm::ivec3(1));
  mNoVolume.clear();
  mNoLabels = gpu::Texture::make3d("no labels", gpu::Format::R8ui, glm::ivec3(1));
  mNoLabels.clear();
  mNoShares = gpu::Texture::make3d("no shares", gpu::Format::Rgba8, glm::ivec3(1));
  mNoShares.clear();
  mNoCells = gpu::Buffer("no cells", 16);
  mNoCells.clear();
}

void UploadPass::bind(const FrameData& data) const {
  const GpuVolume* volume = data.volume;
  bool hasLabels = data.labelUse != LabelUse::None;
  (volume ? volume->texture : mNoVolume).bindSampler(shared::kVolumeUnit);
  if (data.residency) data.residency->bind();
  if (volume && volume->gradient) volume->gradient.bindSampler(shared::kGradientUnit);
  (volume ? volume->cellRange : mNoCells).bindStorage(shared::kCellBinding);
  if (data.hasLabelBricks) return mSheets.bind(), mBricks.bind();
  (hasLabels ? mLabels.texture() : mNoLabels).bindSampler(shared::kLabelUnit);
  (hasLabels ? mShares.covers() : mNoShares).bindSampler(shared::kCoverUnit);
  (hasLabels ? mShares.shares() : mNoShares).bindSampler(shared::kShareUnit);
  (hasLabels ? mShares.coarseShares() : mNoShares).bindSampler(shared::kCoarseShareUnit);
  mSheets.bind();
}

}  // namespace velum::render
