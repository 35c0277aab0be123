#pragma once
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QWidget>

#include "gui/kit/Widgets.h"
#include "scene/Membrane.h"

namespace velum::gui {

/// The brushes of a membrane, and the list of strokes that were drawn with them. The form changes no data itself: it
/// asks by signals.
class SketchForm : public QWidget {
  Q_OBJECT
 public:
  explicit SketchForm(QWidget* parent);
  void showStrokes(const std::vector<scene::Stroke>& strokes);
  /// The buttons of the brushes.
  QPushButton& keepButton() { return *mKeep; }
  QPushButton& avoidButton() { return *mAvoid; }

 signals:
  void radiusAsked(double length);
  void radiusSettled();
  void strokeSelected(int index);
  void removeAsked(int index);

 public slots:
  void showRadius(double radius);
  void showLength(const Length& length);
  void showSelected(int index);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fillList();

  QPushButton *mKeep, *mAvoid, *mRemove;
  NumberRow* mRadius;
  QListWidget* mList;
  std::vector<scene::Stroke> mStrokes;
  double mShownPerLength = 1.0;
};

}  // namespace velum::gui
