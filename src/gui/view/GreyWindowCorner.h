#pragma once
#include <QLineEdit>
#include <QPainter>
#include <QWidget>
#include <string_view>

#include "scene/GreyWindows.h"
#include "session/document/Document.h"

namespace velum::gui {

/// A grey window as text: "Abdomen: W 400 L 50 HU"
QString greyWindowTitle(const scene::GreyWindow& window);
/// Sets the grey window by name, as one undo step.
void setGreyWindow(session::Document& document, std::string_view name);

/// Draws words that can be read over light and dark tissue: light, with a dark seam.
void drawOverTissue(QPainter& painter, const QRectF& box, int flags, const QString& text, int alpha = 225);

/// The width that a text in a lower corner of a section may take, pixels; 0: the section is too small for any text.
double cornerRoom(glm::dvec2 size);
/// The lower right end of the text in a section's lower right corner, pixels.
QPointF lowerRight(glm::dvec2 size);

/// Shows the grey window in the corner of a section, and lets the user type another. Enter takes the typed text, Esc
/// and a click elsewhere leave the window as it was; a text that is not understood stays, marked, and changes nothing.
/// All other mouse events go to the section.
class GreyWindowCorner : public QWidget {
  Q_OBJECT
 public:
  GreyWindowCorner(session::Document& document, QWidget* section);
  /// The corner that belongs to a section view.
  static GreyWindowCorner& of(QWidget& section);
  /// To be called after every change of the document or of the section's size.
  void refresh();
  /// Opens the field in which the grey window is typed.
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
  QLineEdit* mField;  ///< A child of the section, above everything else in it.
  QString mText;
};

}  // namespace velum::gui
