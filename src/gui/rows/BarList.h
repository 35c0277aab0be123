#pragma once
#include <QTreeView>
#include <span>

namespace velum::gui {

/// A list whose rows have cells that are pressed rather than selected: eyes, colours, bars. A bar's knob is dragged,
/// and moved by Ctrl+Left and Ctrl+Right; Esc gives up a drag in lists that can do so. A press that a cell takes does
/// not change the selection. Enter in a row's field enters what was typed there, and is no key of the list: a field
/// passes it on to whatever it stands in.
class BarList : public QTreeView {
  Q_OBJECT
 public:
  static constexpr int kRowHeight = 25;
  static constexpr double kStep = 0.05;  ///< of a whole bar, by the keyboard

 protected:
  explicit BarList(QWidget* parent);
  /// Sets the widths of the columns; to be called once the model is set. @param widths  in pixels; 0: the column has
  /// the width that is left  @param leastRows  how many rows are seen at least
  void layColumns(std::span<const int> widths, int leastRows);

  /// The left button was pressed on a cell. @return true: the cell takes the press
  virtual bool pressCell(const QModelIndex& index, QMouseEvent* event) = 0;
  /// The knob that a press has taken is dragged. @param x  where the knob should be, pixels of the viewport
  virtual void dragKnob(double x) = 0;
  virtual void letKnobGo() = 0;
  /// A knob is held whose drag can be given up.
  virtual bool isKnobHeld() const { return false; }
  virtual void giveKnobUp() {}
  /// The keys that move knobs, and the keys of rows, act on this list rather than on commands of the window that have
  /// the same keys.
  virtual bool hasKeys() const { return true; }
  /// Moves the knob of the current row by some steps to the right. @param isSeen  true: Shift is held, and the knob of
  /// the part that is seen moves
  virtual void stepKnob(int /*steps*/, bool /*isSeen*/) {}

  /// A press at x drags a knob from now on. A press on the knob moves it by as much as the pointer moves; a press
  /// elsewhere brings the knob to the pointer. @param knob  where the knob is; both are pixels of the viewport
  void holdKnob(double x, double knob);
  /// The same for a bar without a knob: its value follows the pointer at once.
  void holdKnob(double x) { holdKnob(x, x + 1e6); }
  /// A cell has taken the press, and the button is still down.
  bool isHeld() const { return mIsHeld; }
  void selectRowOf(const QModelIndex& index, int nameColumn);

  bool event(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  bool mIsHeld = false;      ///< a press was taken by a cell
  bool mIsDragging = false;  ///< the press drags a knob
  double mGrip = 0.0;        ///< how far the pointer is off the knob that it holds
};

}  // namespace velum::gui
