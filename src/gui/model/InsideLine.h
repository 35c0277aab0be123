#pragma once
#include <QLabel>
#include <QWidget>

#include "gui/model/Equalizer.h"
#include "session/document/Document.h"

namespace velum::gui {

/// Where a closed membrane hides what it holds: a line that says so, and a button that cuts it open. Hidden where there
/// is nothing of the kind.
class InsideLine : public QWidget {
  Q_OBJECT
 public:
  InsideLine(session::Document& document, Equalizer& equalizer, QWidget* parent);
  /// To be called after every change.
  void refresh();

 signals:
  /// A plane that shows what is inside.
  void cutAsked();

 private:
  void showCounts();

  session::Document& mDocument;
  Equalizer& mEqualizer;
  QLabel* mWords = nullptr;
};

}  // namespace velum::gui
