#include "velum/session/extrusion/PulledPicture.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>

#include "velum/core/Parallel.h"
#include "velum/scene/Project.h"
#include "velum/session/extrusion/Extrusion.h"
#include "velum/session/structure/StructureEdit.h"

namespace velum::session {

namespace {

/// Light on a surface that is seen along its side; what has gone back is as dark.
constexpr float kAmbient = 0.3f;
constexpr std::uint32_t kGone = 0x90202428;
constexpr int kBrick = LabelVolume::kBrickSize;

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

/// The nearest colour of each pixel, whoever comes first. Distances are positive, so that their bits ascend with them.
class Canvas {
 public:
  explicit Canvas(glm::ivec2 size) : mSize(size), mCells(std::size_t(size.x) * std::size_t(size.y), ~0ull) {}

  void put(glm::ivec2 pixel, float distance, std::uint32_t color) {
    std::uint64_t cell = std::uint64_t(std::bit_cast<std::uint32_t>(distance)) << 32 | color;
    std::atomic_ref<std::uint64_t> there(mCells[index(pixel)]);
    std::uint64_t was = there.load(std::memory_order_relaxed);
    while (cell < was && !there.compare_exchange_weak(was, cell, std::memory_order_relaxed)) {
    }
  }
  /// 0 where nobody has put one.
  std::uint32_t color(glm::ivec2 pixel) const {
    std::uint64_t cell = mCells[index(pixel)];
    return cell == ~0ull ? 0u : std::uint32_t(cell);
  }
  glm::ivec2 size() const { return mSize; }

 private:
  std::size_t index(glm::ivec2 pixel) const {
    return std::size_t(pixel.y) * std::size_t(mSize.x) + std::size_t(pixel.x);
  }
  glm::ivec2 mSize;
  std::vector<std::uint64_t> mCells;
};

std::uint32_t packed(glm::vec3 color) {
  glm::vec3 bytes = glm::round(255.0f * glm::clamp(color, 0.0f, 1.0f));
  return 0xff000000u | std::uint32_t(bytes.r) << 16 | std::uint32_t(bytes.g) << 8 | std::uint32_t(bytes.b);
}

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

 private:
  double ask(glm::ivec3 voxel) const { return depthInCut(mCut, glm::dvec3(mWorldFromVoxel * glm::dvec4(voxel, 1.0))); }
  const scene::Cut& mCut;
  const glm::dmat4& mWorldFromVoxel;
  bool mIsFlat;
  double mAtOrigin;
  glm::dvec3 mPerVoxel{0.0};
};

/// Draws one structure out of one cut.
class Pen {
 public:
  Pen(const scene::Scene& scene, const Pulled& pulled, const scene::Cut& cut, Canvas& canvas)
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
        mEyeFromGradient(glm::transpose(glm::inverse(mEye.fromVoxel()))) {
    for (int axis = 0; axis < 3; ++axis) mVoxel = std::max(mVoxel, glm::length(glm::dvec3(mWorldFromVoxel[axis])));
    if (!mVolume) return;
    mHasGrid = mVolume->dims == mLabels.dims();
    mChannel = std::clamp(mChannel, 0, mVolume->channels - 1);
    mTimeStep = std::clamp(mTimeStep, 0, mVolume->timeSteps - 1);
  }

  void drawBrick(glm::ivec3 index) {
    const auto& brick = mLabels.brick(index);
    bool isUniform = brick.size() == 1;
    if (isUniform && int(brick[0]) != mPulled.structure) return;
    glm::ivec3 first = index * kBrick, end = glm::min(first + kBrick, mLabels.dims());
    for (glm::ivec3 v = first; v.z < end.z; ++v.z)
      for (v.y = first.y; v.y < end.y; ++v.y) {
        const std::uint16_t* row =
            isUniform ? nullptr : &brick[std::size_t(kBrick * (v.y - first.y + kBrick * (v.z - first.z)))];
        for (v.x = first.x; v.x < end.x; ++v.x)
          if (!row || int(row[v.x - first.x]) == mPulled.structure) drawVoxel(v);
      }
  }

 private:
  bool isMine(glm::ivec3 voxel) const { return int(mLabels.at(voxel)) == mPulled.structure; }

  /// A voxel of the structure, where it borders on something that is none of it.
  void drawVoxel(glm::ivec3 voxel) {
    double depth = mDepths.at(voxel), most = std::max(mPulled.distance, mPulled.before);
    if (depth <= 0.0 || depth > most) return;
    bool isGone = depth > mPulled.distance;
    double end = isGone ? most : mPulled.distance;
    glm::dvec3 outwards(0.0);
    bool isSurface = false;
    for (int axis = 0; axis < 3; ++axis)
      for (int step : {-1, 1}) {
        glm::ivec3 beside = voxel;
        beside[axis] += step;
        bool isOpen = !isMine(beside) || mDepths.at(beside) > end;
        isSurface |= isOpen;
        outwards[axis] += isOpen ? step : 0;
      }
    if (isSurface) splat(voxel, outwards, isGone);
  }

  void splat(glm::ivec3 voxel, glm::dvec3 outwards, bool isGone) {
    glm::dvec3 place = mEye.place(glm::dvec3(voxel));
    if (mEye.isBehind(place)) return;
    glm::dvec2 pixel = mEye.pixel(place);
    double radius = std::max(0.5, 0.7 * mVoxel * mEye.pixelsPerLength(place));
    glm::ivec2 low(glm::ceil(pixel - radius - 0.5)), high(glm::floor(pixel + radius - 0.5));
    low = glm::max(low, glm::ivec2(0)), high = glm::min(high, mCanvas.size() - 1);
    if (low.x > high.x || low.y > high.y) return;
    // What has gone lies behind all that is there.
    double distance = isGone ? std::numeric_limits<float>::max() : mEye.distance(place);
    std::uint32_t color = isGone ? kGone : packed(litColor(voxel, outwards, place));
    for (glm::ivec2 p = low; p.y <= high.y; ++p.y)
      for (p.x = low.x; p.x <= high.x; ++p.x) mCanvas.put(p, float(distance), color);
  }

  glm::vec3 litColor(glm::ivec3 voxel, glm::dvec3 outwards, glm::dvec3 place) const {
    glm::dvec3 gradient = mHasGrid ? gradientAt(voxel) : outwards;
    double steep = glm::length(gradient);
    glm::dvec3 normal = mEyeFromGradient * (steep > 0.0 ? gradient : outwards);
    double length = glm::length(normal);
    double light = length > 0.0 ? std::abs(glm::dot(normal, mEye.towardsEye(place))) / length : 1.0;
    glm::vec3 color = mHasGrid ? mColors.at(valueAt(*mVolume, voxel, mChannel, mTimeStep)) : mColors.at(0.0);
    return color * (kAmbient + (1.0f - kAmbient) * float(light));
  }

  glm::dvec3 gradientAt(glm::ivec3 voxel) const {
    glm::dvec3 gradient(0.0);
    for (int axis = 0; axis < 3; ++axis) {
      glm::ivec3 a = voxel, b = voxel;
      a[axis] = std::max(a[axis] - 1, 0), b[axis] = std::min(b[axis] + 1, mVolume->dims[axis] - 1);
      gradient[axis] = valueAt(*mVolume, b, mChannel, mTimeStep) - valueAt(*mVolume, a, mChannel, mTimeStep);
    }
    return gradient;
  }

  const LabelVolume& mLabels;
  Shared<Volume> mVolume;
  int mChannel, mTimeStep;
  const Pulled& mPulled;
  Canvas& mCanvas;
  glm::dmat4 mWorldFromVoxel;
  Eye mEye;
  Depths mDepths;
  Colors mColors;
  glm::dmat3 mEyeFromGradient;
  double mVoxel = 0.0;
  bool mHasGrid = false;
};

/// From behind nothing shows: what a cut keeps lies before it.
bool isSeen(const scene::Scene& scene, const scene::Cut& cut) {
  if (!isFlat(cut)) return true;
  bool isPerspective = scene.camera.projection == scene::Projection::Perspective;
  if (isPerspective) return depthInCut(cut, scene.camera.eye) > 0.0;
  return glm::dot(pullDirection(cut, cut.centre), scene::cameraBasis(scene.camera).forward) < 0.0;
}

void drawOne(const scene::Scene& scene, const Pulled& pulled, Canvas& canvas, const Progress& progress) {
  const scene::Cut* cut = scene::findCut(scene, pulled.cut);
  if (!cut || !scene.labels.data || !(std::max(pulled.distance, pulled.before) > 0.0) || !isSeen(scene, *cut)) return;
  Pen pen(scene, pulled, *cut, canvas);
  glm::ivec3 grid = scene.labels.data->brickGrid();
  parallelFor(0, grid.y * grid.z, [&](int i) {
    progress.throwIfCancelled();
    for (int x = 0; x < grid.x; ++x) pen.drawBrick({x, i % grid.y, i / grid.y});
  });
}

}  // namespace

PulledPicture drawPulled(const scene::Scene& scene, const std::vector<Pulled>& pulled, glm::ivec2 size,
                         const Progress& progress) {
  size = glm::max(size, glm::ivec2(1));
  Canvas canvas(size);
  for (const Pulled& one : pulled) drawOne(scene, one, canvas, progress);
  PulledPicture picture{size.x, size.y, {}};
  picture.pixels.reserve(std::size_t(size.x) * std::size_t(size.y));
  for (glm::ivec2 p(0); p.y < size.y; ++p.y)
    for (p.x = 0; p.x < size.x; ++p.x) picture.pixels.push_back(canvas.color(p));
  return picture;
}

}  // namespace velum::session
