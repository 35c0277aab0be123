// Labels that are edited: only what differs is sent, and what is then on the GPU is what a fresh upload puts there.
#include "render/upload/LabelUpload.h"

#include <fmt/format.h>

#include <random>

#include "RenderFixture.h"
#include "gpu/GpuError.h"

namespace velum {
namespace {

using render::LabelSpace;
using render::LabelUpload;

/// Neither a whole number of bricks nor of blocks.
constexpr glm::ivec3 kLabelUploadDims(75, 50, 70);
constexpr std::size_t kBrickBytes = 32 * 32 * 32 * 2;

LabelSpace spaceOf(glm::ivec3 dims, const glm::dmat4& worldFromVoxel) {
  glm::dmat4 voxelFromTex(1.0);
  for (int axis = 0; axis < 3; ++axis) voxelFromTex[axis][axis] = dims[axis], voxelFromTex[3][axis] = -0.5;
  return {render::cellGridFor(dims), dims, worldFromVoxel * voxelFromTex};
}

LabelVolume startLabels(const glm::dmat4& frame) {
  LabelVolume labels = makeLabels(
      kLabelUploadDims,
      [](glm::ivec3 p) { return glm::length(glm::dvec3(p) - 30.0) < 18 ? 1
                                : p.x > 60 && p.y < 20                 ? 300
                                                                       : 0; }, frame);
  labels.table = {{1, "ball", {0, 1, 0}, 1.0f}, {300, "bar", {0, 0, 1}, 1.0f}};
  return labels;
}

/// One box of one id. @param size  along each axis, as far as it lies in the grid
LabelVolume withBox(LabelVolume labels, glm::ivec3 low, int size, std::uint16_t id) {
  glm::ivec3 extent = glm::min(glm::ivec3(size), labels.dims() - low);
  std::vector<std::uint16_t> ids(std::size_t(extent.x) * std::size_t(extent.y) * std::size_t(extent.z), id);
  labels.write(low, extent, ids);
  auto& table = labels.table;
  auto place = std::lower_bound(table.begin(), table.end(), id, [](const auto& info, int at) { return info.id < at; });
  if (id != 0 && (place == table.end() || place->id != id))
    table.insert(place, {id, "new", defaultLabelColor(id), 1.0f});
  return labels;
}

/// Edits as hands make them: boxes of old ids, of new ones, of none, an id taken away everywhere, steps back.
class Edits {
 public:
  explicit Edits(Shared<LabelVolume> start, unsigned seed) : mPast{std::move(start)}, mRandom(seed) {}
  const Shared<LabelVolume>& next() {
    int kind = pick(5);
    const LabelVolume& now = *mPast.back();
    glm::ivec3 low(pick(kLabelUploadDims.x), pick(kLabelUploadDims.y), pick(kLabelUploadDims.z));
    if (kind == 0 && mPast.size() > 2) {
      mPast.pop_back();
    } else if (kind == 1 && now.table.size() > 1) {
      mPast.emplace_back(without(now, now.table[std::size_t(pick(int(now.table.size())))].id));
    } else {
      int id = kind == 2 ? 0 : kind == 3 ? int(now.table.front().id) : mNextId += 97;
      mPast.emplace_back(withBox(now, low, 1 + pick(25), std::uint16_t(id)));
    }
    return mPast.back();
  }

 private:
  int pick(int count) { return int(mRandom() % unsigned(count)); }
  static LabelVolume without(LabelVolume labels, std::uint16_t id) {
    std::vector<std::uint16_t> ids(std::size_t(kLabelUploadDims.x) * std::size_t(kLabelUploadDims.y) *
                                   std::size_t(kLabelUploadDims.z));
    labels.read({0, 0, 0}, kLabelUploadDims, ids);
    std::replace(ids.begin(), ids.end(), id, std::uint16_t(0));
    labels.write({0, 0, 0}, kLabelUploadDims, ids);
    std::erase_if(labels.table, [&](const LabelInfo& info) { return info.id == id; });
    return labels;
  }
  std::vector<Shared<LabelVolume>> mPast;
  std::mt19937 mRandom;
  int mNextId = 2;
};

class LabelUploadGL : public RenderTest {
 protected:
  static std::vector<std::uint16_t> idsOf(const LabelUpload& upload) {
    glm::ivec3 size = upload.texture().size();
    std::vector<std::uint16_t> ids(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    upload.texture().read(ids.data(), ids.size() * 2);
    return ids;
  }
  static std::size_t differingCells(const std::vector<std::uint64_t>& a, const std::vector<std::uint64_t>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i];
    return count;
  }
  /// Of the bricks in which two label volumes of one grid differ.
  static std::size_t bytesBetween(const LabelVolume& a, const LabelVolume& b) {
    std::size_t bytes = 0;
    glm::ivec3 grid = a.brickGrid();
    for (int i = 0; i < grid.x * grid.y * grid.z; ++i) {
      glm::ivec3 brick(i % grid.x, i / grid.x % grid.y, i / (grid.x * grid.y));
      glm::ivec3 low = brick * 32, size = glm::min(low + 32, a.dims()) - low;
      std::vector<std::uint16_t> p(std::size_t(size.x * size.y * size.z)), q = p;
      a.read(low, size, p);
      b.read(low, size, q);
      if (p != q) bytes += p.size() * 2;
    }
    return bytes;
  }
  /// Labels alone or over a volume, cuts that spare structures of the start and new ones.
  static scene::Scene sceneToEdit(bool isAlone, bool hasSpares, scene::RenderMode mode) {
    scene::Scene scene = sceneOf(makeVolume(
        kLabelUploadDims, SampleType::UInt8,
        [](glm::ivec3 p) { return 60 + 60 * std::sin(p.x * 0.2) * std::cos(p.z * 0.15); },
        centredFrame(kLabelUploadDims)));
    scene.volume.transfer.colors = {{0, {1, 0.8f, 0.6f}}};
    scene.volume.transfer.opacities = {{60, 0}, {110, 0.6}};
    scene.rayCast.mode = mode;
    scene.rayCast.isoValue = 80;
    scene.labels.tint = 0.8;
    scene.labels.unlabelled = 0.2;
    if (isAlone) scene.volume.data = {};
    if (!hasSpares) return scene;
    scene::Cut plane, ball;
    plane.axis = {0.1, -1, 0.2};
    plane.spares = {{300}, {99}, {293, 9.0}};
    ball.shape = scene::CutShape::Sphere;
    ball.centre = {-8, 0, -5};
    ball.size = glm::dvec3(40);
    ball.spares = {{1}, {196}, {99, 4.0}};
    scene.cuts = {plane, ball};
    scene::completeItems(scene);
    return scene;
  }
};

TEST_F(LabelUploadGL, AfterAnyEditsTheGpuHoldsWhatAFreshUploadDoes) {
  glm::dmat4 frame = centredFrame(kLabelUploadDims);
  const LabelSpace kSpaces[] = {
      spaceOf(kLabelUploadDims, frame),
      // A finer grid that is turned against the labels and sticks out, and one that covers a corner of them.
      spaceOf({90, 110, 64}, centredFrame({90, 110, 64}, {0.8, 0.7, 1.1}, 0.5)),
      spaceOf({40, 20, 260}, glm::translate(glm::dmat4(1.0), {20, 15, -40}) * centredFrame({40, 20, 260}, {1, 2, 0.3})),
  };
  unsigned seed = 1;
  for (const LabelSpace& space : kSpaces) {
    Edits edits(Shared<LabelVolume>(startLabels(frame)), seed++);
    LabelUpload kept(context().limits());
    Shared<LabelVolume> before;
    for (int turn = 0; turn < 40; ++turn) {
      Shared<LabelVolume> labels = edits.next();
      std::vector<std::uint64_t> cellsBefore;
      std::uint64_t revisionBefore = kept.cellsRevision();
      if (turn > 0) cellsBefore = kept.cells().sets();
      kept.update(labels, space);
      LabelUpload fresh(context().limits());
      fresh.update(labels, space);
      ASSERT_EQ(idsOf(kept), idsOf(fresh)) << "edit " << turn;
      ASSERT_EQ(kept.cells().sets(), fresh.cells().sets()) << "edit " << turn;
      EXPECT_EQ(fresh.bytesSent(), idsOf(fresh).size() * 2);
      // Exactly the bricks in which some voxel differs; the map of empty space only where some cell does.
      if (turn > 0) {
        EXPECT_EQ(kept.bytesSent(), bytesBetween(*before, *labels)) << "edit " << turn;
        EXPECT_EQ(kept.cellsRevision() != revisionBefore, cellsBefore != kept.cells().sets()) << "edit " << turn;
      }
      before = labels;
    }
  }
}

TEST_F(LabelUploadGL, OneVoxelIsOneBrickAndSeldomAnotherMap) {
  glm::ivec3 dims(256, 256, 256);  // cells of 4^3
  LabelSpace space = spaceOf(dims, centredFrame(dims));
  LabelVolume empty(dims, centredFrame(dims));
  LabelUpload upload(context().limits());
  upload.update(Shared<LabelVolume>(empty), space);
  EXPECT_EQ(upload.bytesSent(), std::size_t(256 * 256 * 256 * 2));
  auto emptyCells = upload.cells().sets();
  std::uint64_t revision = upload.cellsRevision();
  Shared<LabelVolume> edited(withBox(empty, {100, 100, 100}, 1, 40001));
  upload.update(edited, space);
  EXPECT_EQ(upload.bytesSent(), kBrickBytes);
  // The voxel's block is 96..103; a cell of 4 reaches two voxels and a half beyond its sides.
  EXPECT_EQ(differingCells(upload.cells().sets(), emptyCells), 4u * 4 * 4);
  EXPECT_EQ(upload.cellsRevision(), ++revision);
  upload.update(edited, space);
  EXPECT_EQ(upload.bytesSent(), 0u) << "nothing has changed";
  upload.update(Shared<LabelVolume>(withBox(*edited, {101, 101, 101}, 1, 40001)), space);
  EXPECT_EQ(upload.bytesSent(), kBrickBytes) << "its block held the id already";
  upload.update(Shared<LabelVolume>(withBox(*edited, {100, 100, 100}, 1, 40001)), space);
  EXPECT_EQ(upload.bytesSent(), kBrickBytes) << "back";
  upload.update(Shared<LabelVolume>(*edited), space);
  EXPECT_EQ(upload.bytesSent(), 0u) << "another volume, the same bricks";
  EXPECT_EQ(upload.cellsRevision(), revision);
}

TEST_F(LabelUploadGL, AnotherGridOfCellsCostsNoTexels) {
  glm::dmat4 frame = centredFrame(kLabelUploadDims);
  Shared<LabelVolume> labels(startLabels(frame));
  LabelUpload upload(context().limits());
  upload.update(labels, spaceOf(kLabelUploadDims, frame));
  upload.update(labels, spaceOf({20, 20, 20}, centredFrame({20, 20, 20})));
  EXPECT_EQ(upload.bytesSent(), 0u);
  EXPECT_EQ(upload.cells().sets().size(), 5u * 5 * 5);
  EXPECT_EQ(upload.cellsRevision(), 2u);
}

TEST_F(LabelUploadGL, LabelsThatAreTooLargeAreRefusedAndTheNextOnesShown) {
  gpu::Limits limits = context().limits();
  limits.texture3d = 64;
  LabelUpload upload(limits);
  glm::dmat4 frame = centredFrame(kLabelUploadDims);
  EXPECT_THROW(upload.update(Shared<LabelVolume>(startLabels(frame)), spaceOf(kLabelUploadDims, frame)), gpu::GpuError);
  glm::ivec3 small(40, 40, 40);
  upload.update(Shared<LabelVolume>(LabelVolume(small, frame)), spaceOf(small, frame));
  EXPECT_EQ(idsOf(upload), std::vector<std::uint16_t>(40 * 40 * 40, 0));
}

struct EditedPicture {
  const char* what;
  bool isAlone = false, hasSpares = false;
  scene::RenderMode mode = scene::RenderMode::Volume;
};

TEST_F(LabelUploadGL, APictureAfterAnEditIsThatOfLabelsSentWhole) {
  std::size_t whole =
      std::size_t(kLabelUploadDims.x) * std::size_t(kLabelUploadDims.y) * std::size_t(kLabelUploadDims.z) * 2;
  render::Renderer other(context());
  unsigned seed = 7;
  for (const EditedPicture& picture : {EditedPicture{"over a volume"},
                                       {"alone", true},
                                       {"spared, over a volume", false, true},
                                       {"spared, alone", true, true},
                                       {"an isosurface", false, true, scene::RenderMode::Iso},
                                       {"a maximum", false, true, scene::RenderMode::Mip}}) {
    scene::Scene scene = sceneToEdit(picture.isAlone, picture.hasSpares, picture.mode), small = scene;
    small.labels.data = Shared<LabelVolume>(LabelVolume({8, 8, 8}, centredFrame(kLabelUploadDims)));
    draw(small, {4, 4});
    Edits edits(Shared<LabelVolume>(startLabels(centredFrame(kLabelUploadDims))), seed++);
    Shared<LabelVolume> before;
    double shown = 0;
    for (int turn = 0; turn < 12; ++turn) {
      std::string what = picture.what + fmt::format(", turn {}", turn);
      scene.labels.data = edits.next();
      scene.labels.structures.clear();
      scene::completeStructures(scene.labels);
      // What is hidden changes, too, now and then.
      for (auto& structure : scene.labels.structures) structure.visible = (structure.id + turn / 3) % 5 != 3;
      Image image = draw(scene, {40, 40}, kAllLayers);
      EXPECT_EQ(renderer().stats().labelBytes, before ? bytesBetween(*before, *scene.labels.data) : whole) << what;
      before = scene.labels.data;
      shown = std::max(shown, coverageOf(image));
      drawWith(other, small, {4, 4});
      expectIdentical(image, drawWith(other, scene, {40, 40}, kAllLayers), what);
      EXPECT_EQ(other.stats().labelBytes, whole) << what;
      scene.rayCast.skipEmpty = false;
      expectSame(image, draw(scene, {40, 40}), 1.0, what + ", without leaping");
      scene.rayCast.skipEmpty = true;
    }
    EXPECT_GT(shown, 0.02) << picture.what;
  }
}

}  // namespace
}  // namespace velum
