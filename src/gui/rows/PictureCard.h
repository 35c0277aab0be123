#pragma once
#include <QAbstractButton>
#include <QPixmap>

namespace velum::gui {

/// A picture to click on, with a name and a quiet line below it.
class PictureCard : public QAbstractButton {
  Q_OBJECT
 public:
  static constexpr QSize kPicture{208, 130};
  /// @param picture  of kPicture; null: the program's sign
  PictureCard(const QString& title, const QString& line, const QPixmap& picture, QWidget* parent);
  QSize sizeHint() const override;
  /// A card's width, and its height without the lines of text, in pixels.
  static QSize size();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void enterEvent(QEnterEvent*) override { update(); }
  void leaveEvent(QEvent*) override { update(); }

 private:
  QString mLine;
  QPixmap mPicture;
};

}  // namespace velum::gui
