#include "ViewPoint.h"

#include <algorithm>

#include "velum/core/Volume.h"

namespace velum::gui {

namespace {

/// Deep enough for the values there to be the material's own, not those of its border.
constexpr double kBehindVoxels = 2.5;

}  // namespace

const std::optional<render::Pick>& ViewPoint::pick() const {
  if (!mIsPicked) mPick = mView.pickAt(mPlace);
  mIsPicked = true;
  if (mPick && !mPick->hit) mPick.reset();
  return mPick;
}

std::optional<glm::dvec3> ViewPoint::worldMm() const {
  if (const auto* section = mSpace.section()) return scene::worldFromSlicePixel(*section, pixel());
  return pick() ? std::optional(pick()->worldMm) : std::nullopt;
}

std::optional<glm::dvec3> ViewPoint::materialMm(double mostMm) const {
  auto world = worldMm();
  const auto& volume = mScene.volume.data;
  if (!world || isOnSection() || !volume) return world;
  glm::dvec3 spacing = spacingMm(*volume);
  double deep = kBehindVoxels * std::max(spacing.x, std::max(spacing.y, spacing.z));
  return *world - glm::dvec3(pick()->normal) * std::min(deep, mostMm);
}

}  // namespace velum::gui
