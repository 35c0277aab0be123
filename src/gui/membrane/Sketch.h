#pragma once
#include <QObject>
#include <functional>
#include <tuple>
#include <vector>

#include "core/Volume.h"
#include "gui/kit/Messages.h"
#include "gui/service/Selection.h"
#include "gui/tool/Toolbox.h"
#include "session/document/Document.h"

namespace velum::gui {

/// The strokes of the selected membrane over all views, and the edits of them: each is an undo step, after which the
/// membrane's curve is fitted to the strokes anew ([IMC] 3.3). Also holds the radius that the brushes share.
class Sketch : public QObject, public Manipulator {
  Q_OBJECT
 public:
  Sketch(session::Document& document, Selection& selection, Toolbox& toolbox, QObject* parent);

  double radius() const { return mRadius; }
  /// Which stroke of the membrane is marked; -1: none.
  int selected() const { return mSelected; }
  /// A membrane is selected, and there is a volume to stroke over.
  bool isReady() const { return strokes() && mDocument.shown().volume.data; }
  void addStroke(const scene::Stroke& stroke, const std::string& label);
  /// [ and ] change the radius, whichever tool has the pointer.
  KeyAnswer radiusKey(const KeyStroke& stroke);
  void turnRadius(double notches);

  KeyAnswer key(const KeyStroke& stroke) override;
  void refresh() override;
  void paint(ViewPainter& over) const override;

 public slots:
  /// Sets the radius of the brush, and that of the selected stroke.
  void setRadius(double length);
  /// Ends the undo step that a series of radius changes has joined.
  void settleRadius() { mDocument.endMerge(); }
  void select(int stroke);
  void remove(int stroke);

 signals:
  void radiusChanged(double length);
  void selectedChanged(int stroke);

 private:
  using Strokes = std::vector<scene::Stroke>;
  const Strokes* strokes() const;
  void edit(const std::string& label, const std::function<void(Strokes&)>& change, bool merge = false);
  const Histogram& whole();

  session::Document& mDocument;
  Selection& mSelection;
  Toolbox& mToolbox;
  double mRadius = 3.0;
  int mSelected = -1;
  std::tuple<std::uint64_t, int, int> mCounted{};  ///< data, channel and time step of mWhole
  std::uint64_t mFitted = 0;                       ///< the data to whose size the brush was last fitted
  Histogram mWhole;
};

}  // namespace velum::gui
