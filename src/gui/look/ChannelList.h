#pragma once
#include <QWidget>
#include <vector>

#include "gui/kit/Widgets.h"
#include "gui/rows/RowPaint.h"
#include "session/document/Document.h"

namespace velum::gui {

/// The eye of a channel: a click emits pressedWith(), and the eye does not change by itself.
class ChannelEye : public EyeButton {
  Q_OBJECT
 public:
  using EyeButton::EyeButton;

 signals:
  /// @param alone  Alt was held: show this channel and no other
  void pressedWith(bool alone);

 protected:
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;
};

/// The channels of a volume that are mixed: whether each is shown, its colour and its name; the editor edits the
/// channel that is chosen. Hidden for volumes with a single channel. Reads the document, and changes it by edits only.
class ChannelList : public QWidget {
  Q_OBJECT
 public:
  ChannelList(session::Document& document, QWidget* parent);
  void refresh();

 private:
  struct Row {
    QWidget* widget;
    ChannelEye* eye;
    ColorButton* color;
    QPushButton* name;
  };
  void addRow();
  void show(int channel, bool alone);
  void recolor(int channel, glm::vec3 color);
  void choose(int channel);

  session::Document& mDocument;
  std::vector<Row> mRows;
};

}  // namespace velum::gui
