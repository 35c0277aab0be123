#pragma once
#include <optional>
#include <vector>

#include "gui/extrusion/PullPreview.h"
#include "gui/extrusion/SeedStroke.h"
#include "gui/view/Room.h"
#include "session/extrusion/Extrusion.h"
#include "session/extrusion/Pull.h"

namespace velum::gui {

/// Pulls structures out of cuts ([ACS] 4.3): a press on a cut's face, or on what stands out of it, chooses the
/// structure there, and the drag pulls it out as far as the pointer goes. With Shift what was chosen before comes
/// along. Where two extrusions overlap the nearer plane is meant, until Space says the other, as long as the pointer
/// stays there. With Ctrl a stroke gives the selected structure more places to grow from; with Ctrl and Shift a click
/// or a stroke says what is not of it. Everywhere else the view has the pointer. Handles of cuts would lie over what is
/// to be pulled.
///
/// While it is dragged the picture stands, and what is found is shown over it (PullPreview): the thread that moves the
/// label neither grows nor draws. The picture follows when the hand lets go.
class PullTool : public Tool {
  Q_OBJECT
 public:
  explicit PullTool(const WindowParts& parts);

  bool start() override;
  void stop() override;
  bool press(const PointerEvent& event) override;
  void drag(const PointerEvent& event) override;
  void release(const PointerEvent& event) override;
  std::optional<Qt::CursorShape> hover(const ViewPoint& at) override;
  void leave() override;
  bool wheel(const PointerEvent& event, double notches) override;
  KeyAnswer key(const KeyStroke& stroke) override;
  void refresh() override;
  QString hint() const override;
  void paint(ViewPainter& over) const override;
  /// The picture stands, too: see Viewport::drawSome().
  bool pausesOtherViews() const override { return !mDragged.empty() || mStroke; }
  bool hidesHandles() const override { return true; }
  bool marksOverlaps() const override { return true; }
  /// What is said beside the pointer: a name, and how far it stands out.
  const QString& tag() const { return mTag; }
  const PullPreview& preview() const { return mPreview; }
  /// The next press, without any keys, says what is not of the selected structure; Esc takes that back.
  void askWhatIsNotOfIt();

 signals:
  /// Esc: what grows is to stop where it is.
  void stopGrowingAsked();

 private:
  /// What is under the pointer and could be pulled.
  struct Target {
    glm::dvec3 world{0.0};
    int structure = 0;
    std::vector<int> cuts;  ///< out of which, ids, the one that is meant first
  };
  /// Which of several cuts is meant, of a structure that all of them hold.
  struct Meant {
    int structure = 0, cut = 0;
  };
  struct Dragged {
    session::Pull pull;
    session::ExtrusionDrag drag;
    double end, before;  ///< how far it can stand out, and did when it was pressed
  };
  std::optional<Target> targetAt(const ViewPoint& at) const;
  void mean(const Target& target);
  int supporting() const;
  bool begin(const Target& target, const ViewPoint& at, bool goesOn, bool isPart);
  void pullTo(const ViewPoint& at);
  void setDistances(const std::vector<double>& distances);
  void endAtTheirEnds();
  void showPreview();
  void letGo();
  bool isBeside(const ViewPoint& at) const;
  /// What a stroke says of the selected structure.
  enum class Stroke { Add, NotThis };
  void beginStroke(const ViewPoint& at, Stroke stroke);
  void strokeTo(const ViewPoint& at);
  void endStroke();
  void addPlaces(int structure, const std::vector<glm::dvec3>& places);
  void takeAway(int structure, const std::vector<glm::dvec3>& places);
  bool saysNotThis(const PointerEvent& event) const;
  void toggle();
  bool movePlane(double steps);
  QString nameOf(const session::Pull& pull) const;
  QString tagOf(const Target& target) const;

  const WindowParts& mParts;
  session::Document& mDocument;
  Selection& mSelection;
  Toolbox& mToolbox;
  std::vector<session::Pull> mChosen;  ///< with the one that was last pressed on at the end
  std::vector<Dragged> mDragged;       ///< while the pointer is down
  std::optional<SeedStroke> mStroke;   ///< while it is down with Ctrl
  Stroke mStrokeKind = Stroke::Add;
  bool mIsAsking = false;         ///< what is not of it
  std::optional<Target> mTarget;  ///< under the pointer
  Meant mMeant;
  PullPreview mPreview;
  int mShownCount = 0;  ///< of the picture's, when what is laid over it was let go of
  ToolView* mView = nullptr;
  QPointF mPointer;
  QString mTag;
};

}  // namespace velum::gui
