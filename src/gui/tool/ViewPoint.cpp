#include "gui/tool/ViewPoint.h"

#include <algorithm>

#include "core/Volume.h"

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

std::optional<glm::dvec3> ViewPoint::world() const {
  if (const auto* section = mSpace.section()) return scene::worldFromSectionPixel(*section, pixel());
  return pick() ? std::optional(pick()->world) : std::nullopt;
}

std::optional<glm::dvec3> ViewPoint::material(double most) const {
  auto place = world();
  const auto& volume = mScene.volume.data;
  if (!place || isOnSection() || !volume) return place;
  glm::dvec3 spacing = spacingOf(*volume);
  double deep = kBehindVoxels * std::max(spacing.x, std::max(spacing.y, spacing.z));
  return *place - glm::dvec3(pick()->normal) * std::min(deep, most);
}

}  // namespace velum::gui
