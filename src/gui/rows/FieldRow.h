#pragma once
#include <QLayout>
#include <memory>
#include <vector>

namespace velum::gui {

/// Lays fields out side by side, all with the same width, in as many lines as are needed to give each field its least
/// width.
class FieldRow : public QLayout {
 public:
  explicit FieldRow(QWidget* parent);
  ~FieldRow() override;

  void addItem(QLayoutItem* item) override { mItems.emplace_back(item); }
  int count() const override { return int(mItems.size()); }
  QLayoutItem* itemAt(int index) const override;
  QLayoutItem* takeAt(int index) override;
  QSize sizeHint() const override { return minimumSize(); }
  QSize minimumSize() const override;
  Qt::Orientations expandingDirections() const override { return Qt::Horizontal; }
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  void setGeometry(const QRect& rect) override;

 private:
  std::vector<QLayoutItem*> shown() const;
  /// How many fields stand in a line of this width.
  int columnCount(int width) const;

  std::vector<std::unique_ptr<QLayoutItem>> mItems;
};

}  // namespace velum::gui
