#pragma once
#include <QWidget>
#include <vector>

namespace velum::gui {

/// Bars that come and go over a page, in the page's middle at its top or bottom. The page below keeps its place and
/// size, so that nothing moves under the pointer.
class FloatingBars : public QObject {
 public:
  explicit FloatingBars(QWidget& page) : QObject(&page), mPage(page) { page.installEventFilter(this); }
  /// The widget that the bars must be children of.
  QWidget* host() const { return mPage.parentWidget(); }
  /// Adds a bar, which is a sibling of the page, below the bars that are at the top already.
  void addToTop(QWidget& bar) { add(bar, mTop); }
  /// Adds a bar above those that are at the bottom already.
  void addToBottom(QWidget& bar) { add(bar, mBottom); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void add(QWidget& bar, std::vector<QWidget*>& bars);
  void place();

  QWidget& mPage;
  std::vector<QWidget*> mTop, mBottom;
};

}  // namespace velum::gui
