#pragma once
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>
#include <functional>
#include <vector>

#include "gui/kit/NumberField.h"
#include "gui/service/Selection.h"
#include "session/document/Document.h"
#include "session/membrane/SheetHands.h"

namespace velum::gui {

/// The pins and kernels of the selected membrane: the buttons of the tools that put them in, and for each pin or kernel
/// a row with its numbers.
class SheetHandsForm : public QWidget {
  Q_OBJECT
 public:
  SheetHandsForm(session::Document& document, Selection& selection, QWidget* parent);
  void showCut(const scene::Cut& cut);
  /// The buttons of the tools that put in pins and kernels.
  QPushButton& pinButton() { return *mPin; }
  QPushButton& pushButton() { return *mPush; }
  QPushButton& pullButton() { return *mPull; }
  void showSelected(session::Hand hand);

 signals:
  void selectAsked(velum::session::Hand hand);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// The row of a pin or kernel. For a pin `first` is its height over the rest plane; for a kernel `first` and `second`
  /// are radius and strength.
  struct Row {
    QWidget* widget = nullptr;
    QToolButton* name = nullptr;
    NumberField *first = nullptr, *second = nullptr;
    session::Hand hand;
  };
  Row makeRow(session::Hand hand);
  NumberField* makeNumber(QWidget* row, double min, double max, int decimals, const QString& suffix,
                          const QString& name, std::function<void(scene::Cut&, double)> set);
  void showRow(const Row& row, const scene::Cut& cut);
  void showUnheld(const scene::Cut& cut);
  void remove(session::Hand hand);
  void edit(const char* label, const std::function<void(scene::Cut&)>& change, bool merge);

  session::Document& mDocument;
  Selection& mSelection;
  QPushButton *mPin = nullptr, *mPush = nullptr, *mPull = nullptr;
  QWidget* mList = nullptr;
  QVBoxLayout* mRowLayout = nullptr;
  QLabel* mUnheld = nullptr;
  std::vector<Row> mRows;
};

}  // namespace velum::gui
