#pragma once
#include <optional>
#include <vector>

#include "gui/extrusion/PullPreview.h"
#include "gui/extrusion/SeedStroke.h"
#include "gui/service/Job.h"
#include "gui/view/Room.h"
#include "session/extrusion/Extrusion.h"
#include "session/extrusion/Pull.h"

namespace velum::gui {

/// Pulls structures out of cuts ([ACS] 4.3): a press on a cut's face, or on a structure that stands out of it, chooses
/// the structure there, and the drag pulls that structure out as far as the pointer goes. With Shift the structures
/// that were chosen before come along. Where the extrusions of two planes overlap, the nearer plane is meant; Space
/// means the other plane, as long as the pointer stays there. With Ctrl a stroke gives the selected structure more
/// places to grow from; with Ctrl and Shift a click or a stroke shows which parts do not belong to that structure.
/// Everywhere else the view has the pointer. The handles of cuts are hidden, as they would lie over the structures that
/// are to be pulled.
///
/// During a drag the view's picture stands still, and what is found is shown over it (PullPreview): the window's
/// thread, which moves the label, neither grows structures nor draws them. The picture follows when the button is let
/// go.
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
  /// The 3D view's own picture stands still, too: see Viewport::drawSome().
  bool pausesOtherViews() const override { return !mDragged.empty() || mStroke; }
  bool hidesHandles() const override { return true; }
  bool marksOverlaps() const override { return true; }
  /// The label beside the pointer: a structure's name, and how far the structure stands out.
  const QString& tag() const { return mTag; }
  const PullPreview& preview() const { return mPreview; }
  /// The next press, without any keys, shows which parts do not belong to the selected structure; Esc cancels this.
  void askWhatIsNotOfIt();

 signals:
  /// Esc: the structure that grows is to stop where it is.
  void stopGrowingAsked();

 private:
  /// A structure that is under the pointer and could be pulled.
  struct Target {
    glm::dvec3 world{0.0};
    int structure = 0;
    std::vector<int> cuts;  ///< ids of the cuts out of which it can be pulled; first the cut that is meant
  };
  /// Which cut is meant where several cuts hold the same structure.
  struct Meant {
    int structure = 0, cut = 0;
  };
  struct Dragged {
    session::Pull pull;
    session::ExtrusionDrag drag;
    double end, before;  ///< how far the structure can stand out, and how far it did before the drag
  };
  std::optional<Target> targetAt(const ViewPoint& at) const;
  void mean(const Target& target);
  int supporting() const;
  bool begin(const Target& target, const ViewPoint& at, bool goesOn, bool isPart);
  bool beginWhenRead(const Target& target, const ViewPoint& at, bool goesOn, bool isPart);
  void giveUpReading();
  void endDrag();
  void pullTo(const ViewPoint& at);
  void setDistances(const std::vector<double>& distances);
  void endAtTheirEnds();
  void showPreview();
  void letGo();
  bool isBeside(const ViewPoint& at) const;
  /// What a stroke does to the selected structure: Add gives it more places to grow from, NotThis marks parts that do
  /// not belong to it.
  enum class Stroke { Add, NotThis };
  void beginStroke(const ViewPoint& at, Stroke stroke);
  void strokeTo(const ViewPoint& at);
  void endStroke();
  void addPlaces(int structure, const std::vector<glm::dvec3>& places);
  void takeAway(int structure, const std::vector<glm::dvec3>& places);
  bool saysNotThis(const PointerEvent& event) const;
  void toggle();
  bool movePlane(double steps);
  bool hasCutToPullFrom() const;
  QString nameOf(const session::Pull& pull) const;
  QString tagOf(const Target& target) const;

  const WindowParts& mParts;
  session::Document& mDocument;
  Selection& mSelection;
  Toolbox& mToolbox;
  std::vector<session::Pull> mChosen;  ///< the last one is the one that was pressed last
  std::vector<Dragged> mDragged;       ///< while the pointer is down
  std::optional<SeedStroke> mStroke;   ///< while the pointer is down with Ctrl
  Stroke mStrokeKind = Stroke::Add;
  bool mIsAsking = false;         ///< for a press that shows what does not belong to the structure
  std::optional<Target> mTarget;  ///< under the pointer
  Meant mMeant;
  Job* mReading = nullptr;   ///< brings the voxels that decide what was pressed; a child of this
  bool mIsReleased = false;  ///< before they had come
  PullPreview mPreview;
  int mShownCount = 0;  ///< the view's shownCount() when the last drag ended; the preview stays until it differs
  ToolView* mView = nullptr;
  QPointF mPointer;
  QString mTag;
};

}  // namespace velum::gui
