#include "session/measure/Left.h"

#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "core/LabelCover.h"
#include "core/Parallel.h"
#include "render/kept/KeptPlaces.h"
#include "scene/Scene.h"
#include "scene/StructureAt.h"

namespace velum::session {

namespace {

constexpr int kBrickEdge = LabelVolume::kBrickSize;
/// Places that are looked at in a voxel that a border passes, and in one that a face passes.
constexpr std::size_t kBorderPlaces = 32, kFacePlaces = 192;
/// A place counts for a face up to this distance, mean edges of a voxel, the less the further away: thin enough for
/// what is round, thick enough that each face is met by many places.
constexpr double kFaceReach = 0.5;
/// Up to so many half diagonals of a voxel from a face, structures' voxels are compared with what is shown of them:
/// past a whole voxel, so that steps between voxels even out.
constexpr double kAboutReach = 2.0;
/// The distance to a sheet is measured along its frame's axis, which is further than to a steep sheet beside the place.
constexpr double kSheetFactor = 3.0;

/// What lies about a face of a structure, squared units, by places: by their voxels and as pictures show it.
struct AboutFace {
  double voxels = 0.0, shown = 0.0;
};

/// Of one structure.
struct Part {
  StructureLeft sum;
  std::map<int, AboutFace> about;  ///< by the id of the cut

  void addVoxels(glm::ivec3 low, glm::ivec3 high, double volume, double left) {
    sum.whole += volume;
    sum.left += left;
    sum.low = glm::min(sum.low, low);
    sum.high = glm::max(sum.high, high);
  }
  void join(const Part& other) {
    addVoxels(other.sum.low, other.sum.high, other.sum.whole, other.sum.left);
    for (const auto& [cut, area] : other.sum.faces) sum.faces[cut] += area;
    for (const auto& [cut, part] : other.about) {
      about[cut].voxels += part.voxels;
      about[cut].shown += part.shown;
    }
  }
};
using Parts = std::unordered_map<std::uint16_t, Part>;

/// Places that fill the unit cube evenly along any direction, as do the first of them [R2].
std::array<glm::dvec3, kFacePlaces> evenPlaces() {
  constexpr double kRoot = 1.2207440846057596;
  const glm::dvec3 step(1.0 / kRoot, 1.0 / (kRoot * kRoot), 1.0 / (kRoot * kRoot * kRoot));
  std::array<glm::dvec3, kFacePlaces> places;
  for (std::size_t i = 0; i < kFacePlaces; ++i) places[i] = glm::fract(0.5 + double(i) * step);
  return places;
}

/// How far the places of a voxel are shifted, so that those of all voxels along a plane differ.
glm::dvec3 shiftOf(glm::ivec3 voxel) {
  static const glm::dmat3 kRoots(glm::sqrt(glm::dvec3(2, 7, 17)), glm::sqrt(glm::dvec3(3, 11, 19)),
                                 glm::sqrt(glm::dvec3(5, 13, 23)));
  return glm::fract(kRoots * glm::dvec3(voxel));
}

class BrickMeasure {
 public:
  BrickMeasure(const scene::Scene& scene, int only)
      : mLabels(*scene.labels.data),
        mField(scene::structureFieldOf(scene)),
        mWorldFromVoxel(mLabels.worldFromVoxel()),
        mKept(scene, glm::dvec3(mWorldFromVoxel * glm::dvec4(0.5 * glm::dvec3(mLabels.dims() - 1), 1.0))),
        mOnly(only),
        mPlaces(evenPlaces()) {
    glm::dmat3 axes(mWorldFromVoxel);
    mVoxel = std::abs(glm::determinant(axes));
    mFaceReach = kFaceReach * std::cbrt(mVoxel);
    for (double x : {-0.5, 0.5})
      for (double y : {-0.5, 0.5}) mRadius = std::max(mRadius, glm::length(axes * glm::dvec3(x, y, 0.5)));
    mAboutReach = kAboutReach * mRadius;
    mFactor = mKept.hasSheets() ? kSheetFactor : 1.0;
  }

  void add(Parts& parts, glm::ivec3 index) const {
    const LabelVolume::Brick& ids = mLabels.brick(index);
    glm::ivec3 first = index * kBrickEdge, size = glm::min(mLabels.dims() - first, glm::ivec3(kBrickEdge));
    if (ids.size() == 1 && mField->brick(index).size() == 1) {
      if (!isAsked(ids[0])) return;
      glm::dvec3 middle = worldOf(glm::dvec3(first) + 0.5 * glm::dvec3(size - 1));
      if (auto kept = keptAround(middle, ids[0], kBrickEdge)) {
        double volume = mVoxel * double(size.x) * double(size.y) * double(size.z);
        return parts[ids[0]].addVoxels(first, first + size - 1, volume, *kept ? volume : 0.0);
      }
    }
    glm::ivec3 v;
    for (v.z = 0; v.z < size.z; ++v.z)
      for (v.y = 0; v.y < size.y; ++v.y)
        for (v.x = 0; v.x < size.x; ++v.x) {
          std::size_t at = (std::size_t(v.z) * kBrickEdge + std::size_t(v.y)) * kBrickEdge + std::size_t(v.x);
          addVoxel(parts, first + v, ids[ids.size() == 1 ? 0 : at]);
        }
  }

 private:
  glm::dvec3 worldOf(glm::dvec3 voxel) const { return glm::dvec3(mWorldFromVoxel * glm::dvec4(voxel, 1.0)); }
  bool isAsked(std::uint16_t id) const { return id != 0 && (mOnly == 0 || id == mOnly); }

  /// Whether all of a structure about a place is kept; nothing where some of it may not be what the rest is.
  std::optional<bool> keptAround(glm::dvec3 middle, std::uint16_t id, double voxels) const {
    if (mKept.isEmpty()) return true;
    double distance = mKept.distance(middle, id).distance;
    if (std::abs(distance) <= mFactor * (voxels * mRadius + mAboutReach)) return std::nullopt;
    return distance > 0.0;
  }

  void addVoxel(Parts& parts, glm::ivec3 voxel, std::uint16_t id) const {
    bool hasBorder = mField->hasBorder(voxel);
    if (!hasBorder && !isAsked(id)) return;
    auto kept = keptAround(worldOf(voxel), id, 1.0);
    if (kept && isAsked(id)) parts[id].addVoxels(voxel, voxel, mVoxel, *kept ? mVoxel : 0.0);
    if (kept && !hasBorder) return;
    glm::dvec3 shift = shiftOf(voxel), corner = glm::dvec3(voxel) - 0.5;
    std::size_t count = kept ? kBorderPlaces : kFacePlaces, left = 0;
    double volume = mVoxel / double(count);
    for (std::size_t i = 0; i < count; ++i) {
      glm::dvec3 at = corner + glm::fract(mPlaces[i] + shift);
      render::KeptDistance own;
      if (!kept && isAsked(id)) {
        own = mKept.distance(worldOf(at), id);
        if (own.distance >= 0.0) ++left;
        parts[id].about[own.cut].voxels += volume * weightOf(own.distance, mAboutReach);
      }
      std::uint16_t here = hasBorder ? mField->at(at).id : id;
      if (!isAsked(here) || (kept && here == id)) continue;
      render::KeptDistance distance = here == id ? own : mKept.distance(worldOf(at), here);
      parts[here].about[distance.cut].shown += volume * weightOf(distance.distance, mAboutReach);
      double area = volume * weightOf(distance.distance, mFaceReach);
      if (area > 0.0) parts[here].sum.faces[distance.cut] += area;
    }
    if (!kept && isAsked(id)) parts[id].addVoxels(voxel, voxel, mVoxel, mVoxel * (double(left) / double(count)));
  }

  /// A bump about a face, whose integral across the face is 1.
  static double weightOf(double distance, double reach) {
    double off = std::abs(distance) / reach;
    return off < 1.0 ? (1.0 + std::cos(M_PI * off)) / (2.0 * reach) : 0.0;
  }

  const LabelVolume& mLabels;
  std::shared_ptr<const StructureField> mField;
  glm::dmat4 mWorldFromVoxel;
  render::KeptPlaces mKept;
  int mOnly;
  std::array<glm::dvec3, kFacePlaces> mPlaces;
  double mVoxel = 0.0, mRadius = 0.0, mFaceReach = 0.0, mAboutReach = 0.0, mFactor = 1.0;
};

}  // namespace

std::map<int, StructureLeft> measureLeft(const scene::Scene& scene, int only, Progress& progress) {
  std::map<int, StructureLeft> left;
  if (!scene.labels.data) return left;
  BrickMeasure measure(scene, only);
  glm::ivec3 grid = scene.labels.data->brickGrid();
  std::map<int, Part> all;
  auto joined = [](Parts a, const Parts& b) {
    for (const auto& [id, part] : b) a[id].join(part);
    return a;
  };
  for (int z = 0; z < grid.z; ++z) {
    progress.report(double(z) / grid.z, "Measuring structures");
    auto body = [&](int first, int end) {
      Parts parts;
      for (int i = first; i < end && !progress.isCancelled(); ++i) measure.add(parts, {i % grid.x, i / grid.x, z});
      return parts;
    };
    for (const auto& [id, part] : parallelReduce(0, grid.x * grid.y, 4, Parts(), body, joined)) all[id].join(part);
  }
  progress.throwIfCancelled();
  for (auto& [id, part] : all) {
    if (!(part.sum.whole > 0.0)) continue;
    // What is thin is shown thicker than its voxels are: the faces across it, too.
    for (auto& [cut, area] : part.sum.faces)
      if (const AboutFace& about = part.about[cut]; about.shown > 0.0) area *= about.voxels / about.shown;
    left[id] = part.sum;
  }
  return left;
}

}  // namespace velum::session
