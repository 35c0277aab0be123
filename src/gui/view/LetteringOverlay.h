#pragma once
#include <QString>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "core/Model.h"
#include "core/Shared.h"
#include "gui/tool/Manipulator.h"
#include "gui/view/SectionNames.h"
#include "gui/view/Viewport.h"
#include "scene/SceneFwd.h"
#include "session/lettering/Lettering.h"

namespace velum::gui {

/// What is written over the 3D view (scene::Lettering), as over pictures of the view's size, and marks and names over
/// sections. Keeps away from what stands over the views and is no part of pictures, such as the cube.
class LetteringOverlay : public Manipulator {
 public:
  LetteringOverlay(const session::Document& document, Viewport& viewport) : mDocument(document), mViewport(viewport) {}

  /// To be called when a picture is complete: looks which types and structures it shows, and where.
  /// @return true when the lettering has changed
  bool count();
  /// The same when the lettering has changed and the picture has not: goes by what was read of that picture, which is
  /// read only where it was not needed before.
  bool recount();
  /// Marks that are shown, but point at what the 3D picture that was complete last hides: their ids.
  std::set<int> hidden() const;
  /// What the legend names, from its top.
  std::vector<QString> names() const;

  /// Where words of marks and names stand in a view, as they were painted last, its (logical) pixels.
  std::span<const session::PlacedWords> words(const ToolView& view) const;
  /// What marks measure that are not measured at once, by their ids.
  void setMeasured(std::map<int, session::Measured> measured) { mMeasured = std::move(measured); }

  void paint(ViewPainter& over) const override;
  bool isOfPicture() const override { return true; }

 private:
  /// What was read of a picture, as finely as names need it.
  struct Looked {
    Viewport::PixelIds ids;  ///< the size is the picture's
    int step = 1;            ///< of session::SeenMap
    int picture = 0;         ///< its number
    bool isComplete = false, hasDistances = false;
    scene::Camera camera;
    Shared<Model> model;
  };
  /// Places of a picture and what is seen there, in the world.
  using Anchors = std::vector<std::pair<glm::dvec2, glm::dvec3>>;

  bool look(bool isComplete, bool withDistances);
  bool read(bool isComplete, bool withDistances);
  bool countIn(bool isComplete);
  void lookForNames(bool hasNames, bool hasPlaces);
  void findNames(const session::SeenMap& map, bool isSame);
  void findPlaces(const session::SeenMap& map);
  Anchors anchors() const;
  const session::TypePixels& pixels() const;
  session::SeenNames namesFrom(const session::ViewSpace& space) const;
  void keepAnchors(const Anchors& known);

  const session::Document& mDocument;
  Viewport& mViewport;
  std::optional<Looked> mLooked;
  int mReadings = 0, mSeenReading = 0;  ///< how often was read, and of which time mSeen is
  session::TypePixels mPixels;
  std::map<int, session::Measured> mMeasured;
  // For what names were looked for; none: for nothing.
  std::optional<scene::Lettering> mNaming;
  std::vector<scene::Structure> mNamedStructures;
  std::vector<scene::TypeLook> mNamedTypes;
  session::SeenNames mSeen;                 ///< names, as the picture showed them that was complete last
  std::vector<glm::dvec3> mAnchors;         ///< of the names, then of the marks and places in it, in the world
  glm::ivec2 mSize{0};                      ///< of that picture, pixels
  std::vector<session::NamePlace> mPlaces;  ///< of the names in it
  mutable std::map<const ToolView*, std::vector<session::PlacedWords>> mWords;
  mutable std::map<const ToolView*, SectionNames> mSections;
  Shared<Model> mModel;  ///< the model whose types were counted
};

}  // namespace velum::gui
