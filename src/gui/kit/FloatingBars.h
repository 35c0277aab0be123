#pragma once
#include <QWidget>
#include <vector>

namespace velum::gui {

/// Bars that come and go over a page, in its middle at the top or at the bottom: what they cover stays where it is, so
/// that nothing moves under the pointer.
class FloatingBars : public QObject {
 public:
  explicit FloatingBars(QWidget& page) : QObject(&page), mPage(page) { page.installEventFilter(this); }
  /// Whose children the bars are.
  QWidget* host() const { return mPage.parentWidget(); }
  /// A sibling of the page, below those that are there already.
  void addToTop(QWidget& bar) { add(bar, mTop); }
  /// Above those that are there already.
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
