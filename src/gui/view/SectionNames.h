#pragma once
#include <vector>

#include "gui/tool/ToolView.h"
#include "scene/Scene.h"
#include "session/lettering/Lettering.h"

namespace velum::gui {

/// The names over one section view: of the structures that the section cuts.
class SectionNames {
 public:
  /// Looks at the section that a view shows, once for each image that stays and where what is named is new, and finds
  /// its names their places. While the section or a mark moves, names are kept.
  /// @param beside  what else stands in the view
  void look(const scene::Scene& scene, const ToolView& view, const session::Seen& beside);
  /// What was seen last, where a space shows it now.
  session::SeenNames seenFrom(const session::ViewSpace& space) const;
  const std::vector<session::NamePlace>& places() const { return mPlaces; }

 private:
  int mNumber = 0;
  scene::Lettering mNaming;     ///< of the lettering when it was seen, see session::namingOf()
  scene::Lettering mLettering;  ///< for which the names have their places
  std::vector<scene::Structure> mStructures;
  session::SeenNames mSeen;
  session::ViewSpace mSpace;  ///< in which it was seen
  std::vector<session::NamePlace> mPlaces;
};

}  // namespace velum::gui
