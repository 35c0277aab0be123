#pragma once
#include <glm/glm.hpp>
#include <limits>
#include <optional>

#include "gui/kit/Points.h"
#include "gui/tool/ToolView.h"
#include "scene/SceneFwd.h"

namespace velum::gui {

/// A place of a view under the pointer, and what it means in the world: the same for the 3D picture and for sections,
/// so that no tool tells them apart. What is seen there is looked up when it is first asked for.
class ViewPoint {
 public:
  ViewPoint(ToolView& view, const scene::Scene& scene, QPointF place)
      : mView(view), mScene(scene), mPlace(place), mSpace(view.space()) {}

  ToolView& view() const { return mView; }
  QPointF place() const { return mPlace; }
  glm::dvec2 pixel() const { return toVec(mPlace); }
  const session::ViewSpace& space() const { return mSpace; }
  /// A press here has a meaning at once. In the picture it may still become a turn of the camera.
  bool isOnSection() const { return mSpace.section() != nullptr; }

  /// What is seen here; nothing where nothing is hit.
  const std::optional<render::Pick>& pick() const;
  /// On a section any point of its plane; in the picture the surface that is seen. World.
  std::optional<glm::dvec3> world() const;
  /// In the material that is meant: on a section the point itself; in the picture, where the point lies on the
  /// material's border, 2.5 voxels behind it. @param most  but no deeper than this
  std::optional<glm::dvec3> material(double most = std::numeric_limits<double>::infinity()) const;
  /// The labelled region that is seen; 0: none.
  int structure() const { return pick() ? pick()->structure : 0; }
  /// The type of the model's instance that is seen; -1: none.
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
