#pragma once
#include <QHBoxLayout>
#include <QToolButton>
#include <vector>

namespace velum::gui {

/// A line of controls. Where it is too narrow for all of them those that matter least leave it, and what the buttons
/// among them do is in the menu of a button at its end.
class StripLine : public QWidget {
  Q_OBJECT
 public:
  StripLine(int height, QWidget* parent);
  /// Adds a control at the end. @param rank  0: it always stays; of others those of the highest rank leave first
  void add(QWidget* control, int rank);
  void addGap(int pixels);
  void addStretch();
  /// With all that is in it, however much has left.
  QSize sizeHint() const override { return {wholeWidth(), height()}; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Item {
    QWidget* control;
    int rank;
  };
  int wholeWidth() const;
  int widthOf(const QWidget& control) const;
  void fit();
  void fillMenu();

  QHBoxLayout* mLine;
  QToolButton* mMore;
  std::vector<Item> mItems;
  int mGaps = 0;  ///< all together, pixels
};

}  // namespace velum::gui
