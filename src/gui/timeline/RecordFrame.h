#pragma once
#include <QColor>
#include <QWidget>

namespace velum::gui {

/// The colour of recording, in both themes.
inline const QColor kRecordRed(0xe5, 0x48, 0x4d);

/// A red frame about a view, which says that what is changed becomes keys. It takes no events.
class RecordFrame : public QWidget {
 public:
  explicit RecordFrame(QWidget& view);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace velum::gui
