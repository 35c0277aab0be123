#pragma once
#include <QTreeView>
#include <span>

namespace velum::gui {

/// A list whose rows have cells that are pressed rather than selected: eyes, colours, bars. A bar's knob is dragged,
/// and moved by Ctrl+Left and Ctrl+Right; Esc gives a drag up where that can be. What a cell takes is not for the
/// selection.
class BarList : public QTreeView {
  Q_OBJECT
 public:
  static constexpr int kRowHeight = 25;
  static constexpr double kStep = 0.05;  ///< of a whole bar, by the keyboard

 protected:
  explicit BarList(QWidget* parent);
  /// Once the rows are there. @param widths  of columns, pixels; 0: has what is left  @param leastRows  that are seen
  void layColumns(std::span<const int> widths, int leastRows);

  /// The left button on a cell. @return the press is the cell's
  virtual bool pressCell(const QModelIndex& index, QMouseEvent* event) = 0;
  /// What a press has taken is dragged. @param x  where its knob should be, of the viewport
  virtual void dragKnob(double x) = 0;
  virtual void letKnobGo() = 0;
  /// A drag can be given up.
  virtual bool isKnobHeld() const { return false; }
  virtual void giveKnobUp() {}
  /// Keys that move knobs, and those of rows, are the list's own, before commands of the window that have the same.
  virtual bool hasKeys() const { return true; }
  /// The knob of the row that the keyboard is in, so many steps to the right. @param isSeen  Shift: the other knob
  virtual void stepKnob(int /*steps*/, bool /*isSeen*/) {}

  /// A press has taken a knob: whoever takes the knob moves it by what the pointer moves; whoever presses elsewhere
  /// brings it there. @param knob  where it is
  void holdKnob(double x, double knob);
  /// The same of what has none: it comes to the pointer.
  void holdKnob(double x) { holdKnob(x, x + 1e6); }
  /// A cell has taken the press that goes on.
  bool isHeld() const { return mIsHeld; }
  void selectRowOf(const QModelIndex& index, int nameColumn);

  bool event(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  bool mIsHeld = false;      ///< a press was taken by a cell
  bool mIsDragging = false;  ///< and it drags
  double mGrip = 0.0;        ///< how far the pointer is off the knob that it holds
};

}  // namespace velum::gui
