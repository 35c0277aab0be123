#pragma once
#include <QFrame>
#include <QToolButton>
#include <vector>

#include "gui/kit/NumberField.h"
#include "gui/timeline/StripLine.h"
#include "gui/timeline/TrackCanvas.h"

namespace velum::gui {

/// The film of the scene, under the views: buttons and numbers in a row, and the tracks below. What buttons do are
/// commands of the window, see TimelineRoom.
class TimelineStrip : public QFrame {
  Q_OBJECT
 public:
  TimelineStrip(session::Document& document, QWidget* parent);

  /// Adds a button of a command to the row: in the order of the calls, from the left. @param rank  see StripLine
  QToolButton* addCommand(QAction* action, int rank = 0);
  /// Adds what is not of a command: zoom, the ready-made films, the numbers. Called once, after the commands.
  /// @param films  the menu of films
  void finishRow(QMenu& films);
  /// To be called after every change of the document.
  void refresh();
  TrackCanvas& canvas() { return *mCanvas; }

 signals:
  /// The film is to be saved.
  void saveAsked();

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  NumberField* addNumber(const char* object, const QString& name, const QString& tip, int decimals, int rank = 0);
  QToolButton* addButton(const QString& text, const QString& name, const QString& tip, int rank);
  void foldRow();
  void addReadyMade(QMenu& films);
  void addFilmNumbers();
  void setFilm(const char* field, double value, const QString& step);

  session::Document& mDocument;
  QWidget* mRow;
  StripLine *mMoves, *mFilm;  ///< its two parts, which stand one above the other where there is no room
  StripLine* mInto;           ///< the part that is being filled
  TrackCanvas* mCanvas;
  NumberField *mTime = nullptr, *mFrame = nullptr, *mDuration = nullptr, *mRate = nullptr;
  std::optional<double> mGrip;  ///< while the upper edge is dragged: how much of the height is below the pointer
};

}  // namespace velum::gui
