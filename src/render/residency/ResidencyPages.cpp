#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "render/residency/Residency.h"
#include "scene/Project.h"
#include "scene/Scene.h"

// Which level pages want, and in which slot they are.

namespace velum::render {

/// The level whose voxels are about as large as a pixel.
int Residency::levelFor(double pixelSize) const {
  int level = mGrid.coarsest();
  while (level > 0 && mGrid.levels()[std::size_t(level)].voxelSize > kVoxelsPerPixel * pixelSize) --level;
  return level;
}

void Residency::look(const Frame& frame) {
  const scene::Camera& camera = frame.scene.camera;
  scene::CameraBasis basis = scene::cameraBasis(camera);
  Eye eye;
  eye.eye = camera.eye;
  eye.forward = basis.forward;
  eye.pixel = 2.0 * scene::halfPictureHeight(camera) / std::max(1, frame.pictureSize.y);
  eye.isOrthographic = camera.projection == scene::Projection::Orthographic;
  double nearest = eye.isOrthographic ? 1.0 : std::numeric_limits<double>::max();
  if (!eye.isOrthographic) {
    // Where rays of a few pixels enter the data's box.
    glm::dmat4 texFromWorld = glm::inverse(mGrid.levels().front().worldFromTex);
    glm::dvec3 from = texFromWorld * glm::dvec4(eye.eye, 1.0);
    double tall = scene::halfPictureHeight(camera),
           wide = tall * frame.pictureSize.x / std::max(1, frame.pictureSize.y);
    constexpr int kRays = 16;
    for (int i = 0; i <= kRays; ++i)
      for (int j = 0; j <= kRays; ++j) {
        glm::dvec3 way =
            basis.forward + (2.0 * i / kRays - 1.0) * wide * basis.right + (2.0 * j / kRays - 1.0) * tall * basis.up;
        glm::dvec3 d = texFromWorld * glm::dvec4(way, 0.0);
        double enter = 0.0, leave = std::numeric_limits<double>::max();
        for (int axis = 0; axis < 3; ++axis) {
          if (std::abs(d[axis]) < 1e-300) d[axis] = 1e-300;
          double a = -from[axis] / d[axis], b = (1.0 - from[axis]) / d[axis];
          enter = std::max(enter, std::min(a, b));
          leave = std::min(leave, std::max(a, b));
        }
        if (enter < leave) nearest = std::min(nearest, enter);
      }
  }
  bool isSeen = nearest < std::numeric_limits<double>::max();
  eye.nearestPixel = isSeen ? nearest * eye.pixel : std::numeric_limits<double>::max();
  eye.coarser = std::exchange(mStartCoarser, 0.0);
  mEye = eye;
  int level = levelFor(eye.nearestPixel * std::exp2(eye.coarser));
  // While something moves what is there stays, unless it is far from what is wanted.
  bool isNear = mTable.level() >= 0 && std::abs(level - mTable.level()) <= 1;
  if (mTable.level() != level && !(frame.isPreview && isNear)) restartTable(level);
}

void Residency::restartTable(int level) {
  mTable.reset(mGrid, level, mSlots.size());
  mMarks.clear();
  mStreaming.reset();
  const PageLevel& own = mGrid.levels()[std::size_t(level)];
  mVolume.dims = own.dims;
  mVolume.worldFromTex = own.worldFromTex;
  mVolume.cells = cellGridFor(own.dims);
  PagePlace pages;
  pages.grid = mTable.size();
  pages.firstRow = mTable.firstRow();
  pages.perTex = glm::dvec3(own.dims) / own.voxelsPerBox / own.brickEdge;
  pages.first = -own.firstVoxel / own.voxelsPerBox / own.brickEdge;
  mVolume.pages = pages;
  mSeen = gpu::Buffer(
      "pages seen", (std::size_t(pages.grid.x) * std::size_t(pages.grid.y) * std::size_t(pages.grid.z) + 31) / 32 * 4);
  for (std::uint32_t slot = 0; slot < mSlots.size(); ++slot)
    if (slot < kFirstSlot || mSlots[slot].isUsed) writeRow(slot);
  std::vector<PageBrick> bricks;
  for (const auto& slot : mSlots)
    if (slot.isUsed) bricks.push_back(slot.brick);
  for (const auto& brick : bricks) refreshPages(brick);
  mTable.upload();
  mVolume.cellRange = gpu::Buffer("cell ranges", std::size_t(mVolume.cells.size.x) * std::size_t(mVolume.cells.size.y) *
                                                     std::size_t(mVolume.cells.size.z) * sizeof(glm::vec2));
  updateCells();
}

/// Where a slot's voxels lie in the frame's texture coordinates.
void Residency::writeRow(std::uint32_t slot) {
  const PageLevel& own = mGrid.levels()[std::size_t(mTable.level())];
  int level = slot == 0 ? mGrid.coarsest() : mSlots[slot].brick.level;
  const PageLevel& its = mGrid.levels()[std::size_t(level)];
  glm::ivec3 origin = slot < kFirstSlot ? glm::ivec3(0) : mGrid.slotOrigin(mSlots[slot].brick);
  // Its voxels, whose corners are at whole numbers, = tex * scale + first.
  glm::dvec3 scale = glm::dvec3(own.dims) / own.voxelsPerBox * its.voxelsPerBox;
  glm::dvec3 first = its.firstVoxel - own.firstVoxel / own.voxelsPerBox * its.voxelsPerBox;
  if (level == mTable.level()) scale = own.dims, first = glm::dvec3(0.0);  // to the last bit
  SlotRow row{.scale = scale, .first = first - 0.5, .last = its.dims - 1};
  // Wherever a place is in a page that shows nothing, it is seen in the slot's middle.
  if (slot == kEmptySlot) row.scale = glm::vec3(0.0f), row.first = row.last = glm::vec3(0.5f * kSlotEdge);
  if (slot == 0)
    placeCoarseRow(row, mVolume, its.dims);
  else
    placeRow(row, mVolume, mSlots[slot].place, origin);
  mTable.setRow(slot, row);
}

int Residency::wantedAt(glm::ivec3 page) const {
  double pixel = mEye.pixel;
  if (!mEye.isOrthographic) {
    const PageLevel& own = mGrid.levels()[std::size_t(mTable.level())];
    glm::dvec3 tex = (glm::dvec3(page) + 0.5 - mVolume.pages->first) / mVolume.pages->perTex;
    glm::dvec3 world = own.worldFromTex * glm::dvec4(tex, 1.0);
    pixel *= std::max(0.0, glm::dot(world - mEye.eye, mEye.forward));
  }
  return std::max(mTable.level(), levelFor(pixel * std::exp2(mEye.coarser)));
}

/// The slot of the level that a page wants; else of a finer one, else of the least coarse one that is there.
std::uint32_t Residency::bestSlot(glm::ivec3 page, bool mayBeFiner) const {
  int wanted = wantedAt(page);
  PageBrick own{mTable.level(), page};
  auto slotOf = [&](int level) -> std::uint32_t {
    if (level == mGrid.coarsest()) return 0;
    auto found = mResident.find(mGrid.parent(own, level).key());
    return found == mResident.end() ? 0 : found->second;
  };
  if (wanted == mGrid.coarsest()) return 0;
  int finest = mayBeFiner ? mTable.level() : wanted;
  for (int level = wanted; level >= finest; --level)
    if (auto slot = slotOf(level)) return slot;
  for (int level = wanted + 1; level < mGrid.coarsest(); ++level)
    if (auto slot = slotOf(level)) return slot;
  return 0;
}

/// Of a page that begins beyond a depth all samples have voxels of the level that is wanted there: the page's middle
/// says which that is, and a group of samples asks the page of its own middle.
glm::dvec2 Residency::coarsening() const {
  const PageLevel& own = mGrid.levels()[std::size_t(mTable.level())];
  if (mEye.isOrthographic) return {};
  double margin = glm::length(own.spacing) * (0.5 * kPageVoxels + kGroupReach);
  glm::dvec2 found(0.0);
  for (int level = mTable.level() + 1; level <= mGrid.coarsest(); ++level) {
    double voxel = mGrid.levels()[std::size_t(level)].voxelSize;
    double doublings = std::floor(std::log2(voxel / own.voxelSize) + 1e-6);
    if (doublings <= found.y) continue;
    double from = voxel / (kVoxelsPerPixel * mEye.pixel * std::exp2(mEye.coarser)) + margin;
    found = {std::max(found.x, from * std::exp2(1.0 - doublings)), doublings};
  }
  return found;
}

bool Residency::hasFiner(bool drops) {
  bool isFound = false;
  for (std::uint32_t slot = kFirstSlot; slot < mSlots.size(); ++slot) {
    if (!mSlots[slot].isUsed) continue;
    PageTable::Pages pages = mTable.covered(mGrid, mSlots[slot].brick);
    // A coarse brick covers thousands of pages: those that are farthest, at a corner, want the coarsest level.
    bool mayBeFiner = false;
    for (int corner = 0; corner < 8; ++corner)
      mayBeFiner |= wantedAt(glm::mix(pages.low, pages.high - 1, glm::bvec3(corner & 1, corner & 2, corner & 4))) >
                    mSlots[slot].brick.level;
    if (!mayBeFiner) continue;
    glm::ivec3 page;
    for (page.z = pages.low.z; page.z < pages.high.z; ++page.z)
      for (page.y = pages.low.y; page.y < pages.high.y; ++page.y)
        for (page.x = pages.low.x; page.x < pages.high.x; ++page.x) {
          std::size_t index = mTable.indexOf(page);
          if (mTable.slot(index) != slot || wantedAt(page) <= mSlots[slot].brick.level) continue;
          isFound = true;
          if (drops) show(index, bestSlot(page, false));
        }
  }
  if (drops) mTable.upload();
  return isFound;
}

/// A group of samples asks the page of its middle, so that those of a neighbour's group may lie in a page's brick.
std::optional<std::vector<Residency::TexBox>> Residency::changes() const {
  if (!mTable.changes()) return std::nullopt;
  constexpr double kReach = (kGroupReach + 1.0) / kPageVoxels;  // of a page's edge
  std::vector<std::size_t> pages = *mTable.changes();
  std::sort(pages.begin(), pages.end());
  pages.erase(std::unique(pages.begin(), pages.end()), pages.end());
  std::vector<TexBox> boxes;
  for (std::size_t index : pages) {
    glm::dvec3 page(mTable.pageAt(index));
    boxes.push_back({(page - kReach - mVolume.pages->first) / mVolume.pages->perTex,
                     (page + 1.0 + kReach - mVolume.pages->first) / mVolume.pages->perTex});
  }
  return boxes;
}

/// Chooses anew for the pages that a brick covers, which has come or gone.
void Residency::refreshPages(const PageBrick& brick) {
  PageTable::Pages pages = mTable.covered(mGrid, brick);
  glm::ivec3 page;
  for (page.z = pages.low.z; page.z < pages.high.z; ++page.z)
    for (page.y = pages.low.y; page.y < pages.high.y; ++page.y)
      for (page.x = pages.low.x; page.x < pages.high.x; ++page.x) mTable.set(mTable.indexOf(page), bestSlot(page));
}

}  // namespace velum::render
