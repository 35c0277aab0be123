#pragma once
#include <glm/glm.hpp>
#include <limits>
#include <optional>

#include "gui/kit/Points.h"
#include "gui/tool/ToolView.h"
#include "scene/SceneFwd.h"

namespace velum::gui {

/// A place of a view under the pointer, and what it means in the world: the same for the 3D picture and for sections,
/// so that tools need not tell them apart. What is seen at the place is looked up by the first call that asks for it.
class ViewPoint {
 public:
  ViewPoint(ToolView& view, const scene::Scene& scene, QPointF place)
      : mView(view), mScene(scene), mPlace(place), mSpace(view.space()) {}

  ToolView& view() const { return mView; }
  QPointF place() const { return mPlace; }
  glm::dvec2 pixel() const { return toVec(mPlace); }
  const session::ViewSpace& space() const { return mSpace; }
  /// The place is on a section, where a press has a meaning at once; in the 3D picture a press may still become a turn
  /// of the camera.
  bool isOnSection() const { return mSpace.section() != nullptr; }

  /// What is seen at the place; nothing where no object is hit.
  const std::optional<render::Pick>& pick() const;
  /// The place in the world: on a section the point of the section's plane; in the 3D picture the point of the surface
  /// that is seen there, or nothing.
  std::optional<glm::dvec3> world() const;
  /// A place in the world inside the material that is meant: on a section the point itself; in the 3D picture, where
  /// the point lies on the material's border, 2.5 voxels behind the border. @param most  a length: the place is no
  /// deeper than this
  std::optional<glm::dvec3> material(double most = std::numeric_limits<double>::infinity()) const;
  /// The id of the structure that is seen; 0: none.
  int structure() const { return pick() ? pick()->structure : 0; }
  /// The type of the instance of the model that is seen; -1: none.
  int type() const { return pick() ? pick()->type : -1; }

 private:
  ToolView& mView;
  const scene::Scene& mScene;
  QPointF mPlace;
  session::ViewSpace mSpace;
  mutable bool mIsPicked = false;
  mutable std::optional<render::Pick> mPick;
};

}  // namespace velum::gui
