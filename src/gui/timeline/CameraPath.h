#pragma once
#include <functional>
#include <vector>

#include "gui/tool/Toolbox.h"
#include "session/document/Document.h"

namespace velum::gui {

/// The way of the eye through a film, seen in the 3D view from elsewhere: a line with a knob at each key of the camera,
/// and, fainter, the way of what it looks at. A knob that is dragged moves that key's eye in the plane of the picture.
/// It is shown while the view is not the film's own, which would look along it.
class CameraPath : public Manipulator {
 public:
  /// @param isOpen  whether the film is looked at
  CameraPath(session::Document& document, Toolbox& toolbox, std::function<bool()> isOpen);

  bool press(const PointerEvent& event) override;
  void drag(const PointerEvent& event) override;
  void release(const PointerEvent& event) override;
  std::optional<Qt::CursorShape> hover(const ViewPoint& at) override;
  void leave() override;
  void refresh() override;
  void paint(ViewPainter& over) const override;

  bool isShown() const { return mIsShown; }
  /// The eyes at the keys of the camera, in the order of their times. World.
  std::vector<glm::dvec3> keyEyes() const;

 private:
  struct Stop {
    double time = 0.0;
    scene::Camera camera;  ///< with the film's turn
    bool isKey = false;    ///< of the camera: its knob can be dragged
  };
  int knobUnder(const ViewPoint& at) const;
  void setHover(int knob);

  session::Document& mDocument;
  Toolbox& mToolbox;
  std::function<bool()> mIsOpen;
  bool mIsShown = false;
  std::vector<scene::Track> mTracks;  ///< those that move the eye, of which the rest was made
  scene::Camera mCamera;              ///< of the scene, for what they leave out
  double mDuration = 0.0;
  std::vector<Stop> mStops, mKnobs;
  int mHover = -1;
  // While a knob is dragged.
  int mHeld = -1;
  scene::Camera mStart;
  session::ViewSpace mSpace;
  glm::dvec2 mFrom{0.0};
};

}  // namespace velum::gui
