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

/// The strokes of the selected membrane over all views, and what can be done to them: each change is an undo step,
/// after which the membrane's curve is fitted anew ([IMC] 3.3). And the radius that its brushes share.
class Sketch : public QObject, public Manipulator {
  Q_OBJECT
 public:
  Sketch(session::Document& document, Selection& selection, Toolbox& toolbox, QObject* parent);

  double radius() const { return mRadius; }
  /// Which stroke of the membrane is marked; -1: none.
  int selected() const { return mSelected; }
  /// There is a membrane to stroke for, and data to stroke over.
  bool isReady() const { return strokes() && mDocument.scene().volume.data; }
  void addStroke(const scene::Stroke& stroke, const std::string& label);
  /// [ and ] change the radius, whoever has the pointer.
  KeyAnswer radiusKey(const KeyStroke& stroke);
  void turnRadius(double notches);

  KeyAnswer key(const KeyStroke& stroke) override;
  void refresh() override;
  void paint(ViewPainter& over) const override;

 public slots:
  /// Of the brush, and of the marked stroke.
  void setRadius(double mm);
  /// One undo step of radii ends.
  void settleRadius() { mDocument.endMerge(); }
  void select(int stroke);
  void remove(int stroke);

 signals:
  void radiusChanged(double mm);
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
  std::uint64_t mFitted = 0;                       ///< data to whose size the brush was last made
  Histogram mWhole;
};

}  // namespace velum::gui
