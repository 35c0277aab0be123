#pragma once
#include <QListWidget>
#include <QPixmap>
#include <string_view>

#include "core/Image.h"

namespace velum::gui {

/// A UTF-8 text of the program's tables as Qt's text.
inline QString textOf(std::string_view text) { return QString::fromUtf8(text.data(), int(text.size())); }

/// An Image as Qt's picture; without its alpha.
QImage toQImage(const Image& image);

/// Small pictures with names below them, of which one is chosen: by a click, by Enter or Space. The list is as high as
/// all of its rows, so that the panel scrolls rather than the list. Items hold their name as their data.
class PictureList : public QListWidget {
  Q_OBJECT
 public:
  /// @param pictureHeight  pixels
  PictureList(int columns, int pictureHeight, QWidget* parent);
  void add(const QString& name, const QString& title, const QString& tip, const QPixmap& picture);
  void setPicture(const QString& name, const QPixmap& picture);
  QStringList names() const;
  /// Name and title of each picture.
  QList<std::pair<QString, QString>> titles() const;
  /// Marks the picture of a name; no picture where the name is not in the list. Emits no signal.
  void mark(const QString& name);
  /// Makes the list as wide as this, and as high as its rows then need.
  void fit(int width);
  /// The size of a picture on the screen, in device pixels.
  QSize pictureSize() const;

 signals:
  void chosen(const QString& name);

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  QListWidgetItem* find(const QString& name) const;
  const int mColumns, mPictureHeight;
};

}  // namespace velum::gui
