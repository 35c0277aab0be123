#pragma once
#include <QLineEdit>
#include <QPainter>
#include <QWidget>
#include <string_view>

#include "scene/GreyWindows.h"
#include "session/document/Document.h"

namespace velum::gui {

/// "Abdomen: W 400  L 50 HU"
QString greyWindowTitle(const scene::GreyWindow& window);
/// Sets the grey window by name, as one undo step.
void setGreyWindow(session::Document& document, std::string_view name);

/// Words over light and dark tissue: light, with a dark seam.
void drawOverTissue(QPainter& painter, const QRectF& box, int flags, const QString& text, int alpha = 225);

/// What a text in a lower corner of a section may take, pixels; 0: the section is too small for any.
double cornerRoom(glm::dvec2 size);
/// The end of what stands in its lower right corner.
QPointF lowerRight(glm::dvec2 size);

/// The grey window in the corner of a section: it says it, and lets it be typed. Enter takes what is typed, Esc and a
/// click elsewhere leave it; what is not understood stays, marked, and changes nothing. What else the mouse does is the
/// section's.
class GreyWindowCorner : public QWidget {
  Q_OBJECT
 public:
  GreyWindowCorner(session::Document& document, QWidget* section);
  /// Of a section view.
  static GreyWindowCorner& of(QWidget& section);
  /// To be called after every change of the document or of the section's size.
  void refresh();
  /// Lets it be typed.
  void startTyping();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void enterEvent(QEnterEvent* event) override;
  void leaveEvent(QEvent* event) override;
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  void take();
  void mark(bool isRefused);

  session::Document& mDocument;
  QLineEdit* mField;  ///< The section's, over all of it.
  QString mText;
};

}  // namespace velum::gui
