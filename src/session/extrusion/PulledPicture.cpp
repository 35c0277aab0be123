#include "session/extrusion/PulledPicture.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>

#include "scene/Project.h"
#include "session/extrusion/Extrusion.h"
#include "session/extrusion/PulledCanvas.h"
#include "session/structure/StructureEdit.h"

namespace velum::session {

namespace {

constexpr int kBrick = LabelVolume::kBrickSize;
using Bits = std::uint64_t;

/// Where voxels are in the picture.
class Eye {
 public:
  Eye(const scene::Camera& camera, glm::dvec2 size, const glm::dmat4& worldFromVoxel)
      : mMiddle(0.5 * size), mIsPerspective(camera.projection == scene::Projection::Perspective) {
    scene::CameraBasis basis = scene::cameraBasis(camera);
    glm::dmat3 eyeFromWorld = glm::transpose(glm::dmat3(basis.right, basis.up, basis.forward));
    mFromVoxel = eyeFromWorld * glm::dmat3(worldFromVoxel);
    mOrigin = eyeFromWorld * (glm::dvec3(worldFromVoxel[3]) - camera.eye);
    mScale = 0.5 * size.y / scene::halfPictureHeight(camera);
  }
  glm::dvec3 place(glm::dvec3 voxel) const { return mFromVoxel * voxel + mOrigin; }
  glm::dvec2 pixel(glm::dvec3 place) const {
    double scale = mIsPerspective ? mScale / place.z : mScale;
    return mMiddle + scale * glm::dvec2(place.x, -place.y);
  }
  double distance(glm::dvec3 place) const { return mIsPerspective ? glm::length(place) : place.z; }
  bool isBehind(glm::dvec3 place) const { return mIsPerspective && place.z <= 0.0; }
  double pixelsPerLength(glm::dvec3 place) const { return mIsPerspective ? mScale / place.z : mScale; }
  glm::dvec3 towardsEye(glm::dvec3 place) const {
    return mIsPerspective ? -glm::normalize(place) : glm::dvec3(0.0, 0.0, -1.0);
  }
  const glm::dmat3& fromVoxel() const { return mFromVoxel; }

 private:
  glm::dvec2 mMiddle;
  bool mIsPerspective;
  glm::dmat3 mFromVoxel;
  glm::dvec3 mOrigin;
  double mScale;
};

/// The colours of a structure by its values, as far as it does not take its own.
class Colors {
 public:
  Colors(const scene::Scene& scene, int structure) : mVolume(scene.volume.data) {
    const scene::Structure* row = findStructure(scene, structure);
    float tint = row ? float(row->tint * scene.labels.tint) : 0.0f;
    glm::vec3 own = row ? row->color : defaultLabelColor(std::uint16_t(structure));
    if (!mVolume) tint = 1.0f;
    mTable.assign(kCount, own);
    if (!mVolume) return;
    mLow = mVolume->range.x;
    mPerValue = (kCount - 1) / std::max(mVolume->range.y - mVolume->range.x, 1e-300);
    const auto& colors = scene::currentTransfer(scene.volume).colors;
    if (colors.empty()) return;
    for (int i = 0; i < kCount; ++i)
      mTable[std::size_t(i)] = glm::mix(glm::vec3(scene::colorAt(colors, mLow + i / mPerValue)), own, tint);
  }
  glm::vec3 at(double value) const {
    double place = (value - mLow) * mPerValue;
    return mTable[std::size_t(std::isfinite(place) ? std::clamp(int(place), 0, kCount - 1) : 0)];
  }

 private:
  static constexpr int kCount = 512;
  Shared<Volume> mVolume;
  std::vector<glm::vec3> mTable;
  double mLow = 0.0, mPerValue = 0.0;
};

/// How deep voxels lie in what a cut removes.
class Depths {
 public:
  Depths(const scene::Cut& cut, const glm::dmat4& worldFromVoxel)
      : mCut(cut), mWorldFromVoxel(worldFromVoxel), mIsFlat(isFlat(cut)), mAtOrigin(ask({0, 0, 0})) {
    for (int axis = 0; axis < 3; ++axis) {
      glm::ivec3 step(0);
      step[axis] = 1;
      mPerVoxel[axis] = ask(step) - mAtOrigin;
    }
  }
  double at(glm::ivec3 voxel) const {
    return mIsFlat ? mAtOrigin + glm::dot(mPerVoxel, glm::dvec3(voxel)) : ask(voxel);
  }
  /// Of some voxels of a row those that lie no deeper. @param bits  bit i is `first` moved by i along x
  Bits upTo(double depth, glm::ivec3 first, Bits bits) const {
    if (bits == 0) return bits;
    if (mIsFlat) return bits & flatUpTo(depth - at(first));
    for (Bits left = bits; left != 0; left &= left - 1) {
      int i = std::countr_zero(left);
      if (at(first + glm::ivec3(i, 0, 0)) > depth) bits &= ~(Bits(1) << i);
    }
    return bits;
  }
  /// All of a box lies no deeper, or none of it does; nothing where it is neither, or not known.
  std::optional<bool> boxIsUpTo(double depth, glm::ivec3 first, glm::ivec3 last) const {
    if (!mIsFlat) return std::nullopt;
    int shallow = 0;
    for (int i = 0; i < 8; ++i) shallow += at(glm::mix(first, last, glm::bvec3(i & 1, i >> 1 & 1, i >> 2))) <= depth;
    return shallow == 8 ? std::optional(true) : shallow == 0 ? std::optional(false) : std::nullopt;
  }

 private:
  /// Of a whole row, whose first voxel lies `left` less deep.
  Bits flatUpTo(double left) const {
    double step = mPerVoxel.x, count = std::floor(left / step);  // voxels behind the first one
    if (!std::isfinite(count)) return left >= 0.0 ? ~Bits(0) : 0;
    if (step > 0.0) return count < 0.0 ? 0 : count >= 63.0 ? ~Bits(0) : (Bits(2) << int(count)) - 1;
    return count < 0.0 ? ~Bits(0) : count >= 63.0 ? 0 : ~Bits(0) << int(std::ceil(left / step));
  }
  double ask(glm::ivec3 voxel) const { return depthInCut(mCut, glm::dvec3(mWorldFromVoxel * glm::dvec4(voxel, 1.0))); }
  const scene::Cut& mCut;
  const glm::dmat4& mWorldFromVoxel;
  bool mIsFlat;
  double mAtOrigin;
  glm::dvec3 mPerVoxel{0.0};
};

/// The rows of a brick, y fastest: a bit for each voxel.
using BrickRows = std::array<std::uint32_t, std::size_t(kBrick* kBrick)>;
static_assert(kBrick == 32);

/// Voxels of a brick, and of the one layer around it, as bits of rows.
struct BrickBits {
  static constexpr int kWide = kBrick + 2;
  glm::ivec3 first;  ///< voxel of the first bit of the first row
  std::array<Bits, std::size_t(kWide* kWide)> rows{};

  Bits& row(int y, int z) { return rows[std::size_t(z * kWide + y)]; }
  Bits row(int y, int z) const { return rows[std::size_t(z * kWide + y)]; }
  glm::ivec3 rowStart(int y, int z) const { return first + glm::ivec3(0, y, z); }
};

/// Draws one structure out of one cut.
class Pen {
 public:
  Pen(const scene::Scene& scene, const Pulled& pulled, const scene::Cut& cut, PulledCanvas& canvas)
      : mLabels(*scene.labels.data),
        mVolume(scene.volume.data),
        mChannel(scene.volume.channel),
        mTimeStep(scene.volume.timeStep),
        mPulled(pulled),
        mCanvas(canvas),
        mWorldFromVoxel(mLabels.worldFromVoxel()),
        mEye(scene.camera, glm::dvec2(canvas.size()), mWorldFromVoxel),
        mDepths(cut, mWorldFromVoxel),
        mColors(scene, pulled.structure),
        mFacesFromEye(glm::inverse(mEye.fromVoxel())) {
    for (const scene::Cut* other : joinedWith(scene, cut)) mJoined.emplace_back(*other, mWorldFromVoxel);
    glm::ivec3 grid = mLabels.brickGrid();
    mRows.resize(std::size_t(grid.x) * std::size_t(grid.y) * std::size_t(grid.z));
    for (int axis = 0; axis < 3; ++axis) mVoxel = std::max(mVoxel, glm::length(glm::dvec3(mWorldFromVoxel[axis])));
    if (!mVolume) return;
    mHasGrid = mVolume->dims == mLabels.dims();
    mChannel = std::clamp(mChannel, 0, mVolume->channels - 1);
    mTimeStep = std::clamp(mTimeStep, 0, mVolume->timeSteps - 1);
  }

  void drawBrick(glm::ivec3 index) {
    const auto& brick = mLabels.brick(index);
    if (brick.size() == 1 && int(brick[0]) != mPulled.structure) return;
    glm::ivec3 first = index * kBrick, last = first + kBrick - 1;
    if (mDepths.boxIsUpTo(0.0, first, last) == true) return;
    if (mDepths.boxIsUpTo(std::max(mPulled.distance, mPulled.before), first, last) == false) return;
    BrickBits all = bitsOf(index);
    BrickBits out = upTo(all, mDepths, mPulled.distance), within = upTo(all, mDepths, 0.0);
    for (const Depths& joined : mJoined) {
      BrickBits kept = upTo(all, joined, 0.0);
      for (std::size_t i = 0; i < kept.rows.size(); ++i) within.rows[i] |= kept.rows[i];
    }
    drawSurface(out, within, false);
    if (mPulled.before > mPulled.distance) {
      for (std::size_t i = 0; i < out.rows.size(); ++i) within.rows[i] |= out.rows[i];
      drawSurface(upTo(all, mDepths, mPulled.before), within, true);
    }
  }

 private:
  /// The structure in a brick and around it.
  BrickBits bitsOf(glm::ivec3 index) {
    constexpr int kLast = BrickBits::kWide - 1;
    BrickBits bits{index * kBrick - 1, {}};
    for (int z = 0; z <= kLast; ++z)
      for (int y = 0; y <= kLast; ++y) {
        glm::ivec3 of = index + glm::ivec3(0, besideOf(y), besideOf(z));
        std::size_t row = std::size_t((z + kBrick - 1) % kBrick * kBrick + (y + kBrick - 1) % kBrick);
        bits.row(y, z) = Bits(rowsOf(of)[row]) << 1 | Bits(rowsOf(of - glm::ivec3(1, 0, 0))[row]) >> (kBrick - 1) |
                         (Bits(rowsOf(of + glm::ivec3(1, 0, 0))[row]) & 1) << (kBrick + 1);
      }
    return bits;
  }
  static int besideOf(int place) { return place == 0 ? -1 : place > kBrick ? 1 : 0; }

  /// Of a brick, each row of which is a word; nothing of it outside of the grid.
  const BrickRows& rowsOf(glm::ivec3 index) {
    static const BrickRows kNone{}, kAll = [] {
      BrickRows rows;
      rows.fill(~0u);
      return rows;
    }();
    glm::ivec3 grid = mLabels.brickGrid();
    if (glm::any(glm::lessThan(index, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(index, grid))) return kNone;
    const auto& brick = mLabels.brick(index);
    bool isWhole = glm::all(glm::lessThanEqual((index + 1) * kBrick, mLabels.dims()));
    if (brick.size() == 1 && (isWhole || int(brick[0]) != mPulled.structure))
      return int(brick[0]) == mPulled.structure ? kAll : kNone;
    auto& rows = mRows[std::size_t(index.x + grid.x * (index.y + grid.y * index.z))];
    if (!rows) rows = std::make_unique<BrickRows>(packed(index));
    return *rows;
  }
  BrickRows packed(glm::ivec3 index) const {
    const auto& brick = mLabels.brick(index);
    glm::ivec3 size = glm::min(mLabels.dims() - index * kBrick, glm::ivec3(kBrick));
    auto id = std::uint16_t(mPulled.structure);
    BrickRows rows{};
    for (int z = 0; z < size.z; ++z)
      for (int y = 0; y < size.y; ++y) {
        std::size_t row = std::size_t(z * kBrick + y);
        std::uint32_t bits = ~0u;
        if (brick.size() > 1) bits = packed(&brick[row * kBrick], id);
        rows[row] = size.x == kBrick ? bits : bits & ((1u << size.x) - 1);
      }
    return rows;
  }
  /// Which of 32 ids are this one: as bytes first, which a processor compares many at a time.
  static std::uint32_t packed(const std::uint16_t* ids, std::uint16_t id) {
    std::array<std::uint8_t, kBrick> is;
    for (int i = 0; i < kBrick; ++i) is[std::size_t(i)] = ids[i] == id;
    std::uint32_t bits = 0;
    for (int i = 0; i < kBrick / 8; ++i) {
      std::uint64_t eight;
      std::memcpy(&eight, &is[std::size_t(8 * i)], 8);
      bits |= std::uint32_t(eight * 0x0102040810204080u >> 56) << (8 * i);
    }
    return bits;
  }
  static BrickBits upTo(BrickBits bits, const Depths& depths, double depth) {
    constexpr int kLast = BrickBits::kWide - 1;
    auto isUpTo = depths.boxIsUpTo(depth, bits.first, bits.first + kLast);
    if (isUpTo && !*isUpTo) bits.rows.fill(0);
    if (isUpTo) return bits;
    for (int z = 0; z <= kLast; ++z)
      for (int y = 0; y <= kLast; ++y) bits.row(y, z) = depths.upTo(depth, bits.rowStart(y, z), bits.row(y, z));
    return bits;
  }

  /// What of `out` borders on what is none of it, but for what lies within the cut.
  void drawSurface(const BrickBits& out, const BrickBits& within, bool isGone) {
    constexpr Bits kInside = ((Bits(1) << kBrick) - 1) << 1;
    for (int z = 1; z <= kBrick; ++z)
      for (int y = 1; y <= kBrick; ++y) {
        Bits row = out.row(y, z);
        Bits beside[6] = {row << 1,          row >> 1,          out.row(y - 1, z),
                          out.row(y + 1, z), out.row(y, z - 1), out.row(y, z + 1)};
        Bits whole = ~Bits(0);
        for (Bits one : beside) whole &= one;
        for (Bits left = row & ~within.row(y, z) & ~whole & kInside; left != 0; left &= left - 1) {
          int x = std::countr_zero(left);
          glm::ivec3 open[2];  // towards lower and higher places of each axis
          for (int i = 0; i < 6; ++i) open[i & 1][i >> 1] = (beside[i] >> x & 1) == 0;
          draw(out.rowStart(y, z) + glm::ivec3(x, 0, 0), open[0], open[1], isGone);
        }
      }
  }

  /// Nothing where all of its open faces are seen from behind.
  void draw(glm::ivec3 voxel, glm::ivec3 openBelow, glm::ivec3 openAbove, bool isGone) {
    glm::dvec3 place = mEye.place(glm::dvec3(voxel));
    if (mEye.isBehind(place)) return;
    glm::dvec3 facing = mFacesFromEye * mEye.towardsEye(place);
    bool isSeen = false;
    for (int axis = 0; axis < 3; ++axis)
      isSeen |= facing[axis] > 0.0 ? openAbove[axis] != 0 : facing[axis] < 0.0 && openBelow[axis] != 0;
    if (isSeen) splat(voxel, place, isGone);
  }

  void splat(glm::ivec3 voxel, glm::dvec3 place, bool isGone) {
    glm::dvec2 pixel = mEye.pixel(place);
    double radius = std::max(0.5, 0.7 * mVoxel * mEye.pixelsPerLength(place));
    glm::ivec2 low(glm::ceil(pixel - radius - 0.5)), high(glm::floor(pixel + radius - 0.5));
    low = glm::max(low, glm::ivec2(0)), high = glm::min(high, mCanvas.size() - 1);
    if (low.x > high.x || low.y > high.y) return;
    if (isGone) return mCanvas.putGone(low, high);
    mCanvas.setScale(mVoxel, mEye.pixelsPerLength(place));
    mCanvas.put(low, high, float(mEye.distance(place)), colorOf(voxel));
  }

  glm::vec3 colorOf(glm::ivec3 voxel) const {
    return mColors.at(mHasGrid ? valueAt(*mVolume, voxel, mChannel, mTimeStep) : 0.0);
  }

  const LabelVolume& mLabels;
  Shared<Volume> mVolume;
  int mChannel, mTimeStep;
  const Pulled& mPulled;
  PulledCanvas& mCanvas;
  glm::dmat4 mWorldFromVoxel;
  Eye mEye;
  Depths mDepths;
  std::vector<Depths> mJoined;  ///< cuts that keep some of what this one removes
  Colors mColors;
  glm::dmat3 mFacesFromEye;
  double mVoxel = 0.0;
  bool mHasGrid = false;
  std::vector<std::unique_ptr<BrickRows>> mRows;  ///< of bricks that have been looked at
};

/// From behind nothing shows: what a cut keeps lies before it.
bool isSeen(const scene::Scene& scene, const scene::Cut& cut) {
  if (!isFlat(cut)) return true;
  bool isPerspective = scene.camera.projection == scene::Projection::Perspective;
  if (isPerspective) return depthInCut(cut, scene.camera.eye) > 0.0;
  return glm::dot(pullDirection(cut, cut.centre), scene::cameraBasis(scene.camera).forward) < 0.0;
}

void drawOne(const scene::Scene& scene, const Pulled& pulled, PulledCanvas& canvas, const Progress& progress) {
  const scene::Cut* cut = scene::findCut(scene, pulled.cut);
  if (!cut || !scene.labels.data || !(std::max(pulled.distance, pulled.before) > 0.0) || !isSeen(scene, *cut)) return;
  Pen pen(scene, pulled, *cut, canvas);
  glm::ivec3 grid = scene.labels.data->brickGrid();
  for (glm::ivec3 b(0); b.z < grid.z; ++b.z)
    for (b.y = 0; b.y < grid.y; ++b.y) {
      progress.throwIfCancelled();
      for (b.x = 0; b.x < grid.x; ++b.x) pen.drawBrick(b);
    }
}

}  // namespace

PulledPicture drawPulled(const scene::Scene& scene, const std::vector<Pulled>& pulled, glm::ivec2 size,
                         const Progress& progress) {
  size = glm::max(size, glm::ivec2(1));
  PulledCanvas canvas(size);
  for (const Pulled& one : pulled) drawOne(scene, one, canvas, progress);
  return {size.x, size.y, canvas.pixels()};
}

}  // namespace velum::session
