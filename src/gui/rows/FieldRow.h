#pragma once
#include <QLayout>
#include <memory>
#include <vector>

namespace velum::gui {

/// Fields side by side, all as wide as each other, in as many lines as it takes that none is narrower than it must be.
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
  /// How many stand in a line of this width.
  int columnCount(int width) const;

  std::vector<std::unique_ptr<QLayoutItem>> mItems;
};

}  // namespace velum::gui
