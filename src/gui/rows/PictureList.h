#pragma once
#include <QListWidget>
#include <QPixmap>
#include <string_view>

#include "core/Image.h"

namespace velum::gui {

/// A word of our tables as Qt has it.
inline QString textOf(std::string_view text) { return QString::fromUtf8(text.data(), int(text.size())); }

/// A picture of ours as Qt has it; without its alpha.
QImage toQImage(const Image& image);

/// Small pictures with names below them, of which one is chosen: by a click, by Enter or Space. It is as high as all of
/// its rows; the panel scrolls. Items hold their name as their data.
class PictureList : public QListWidget {
  Q_OBJECT
 public:
  /// @param pictureHeight  pixels
  PictureList(int columns, int pictureHeight, QWidget* parent);
  void add(const QString& name, const QString& title, const QString& tip, const QPixmap& picture);
  void setPicture(const QString& name, const QPixmap& picture);
  QStringList names() const;
  /// Name and title of each.
  QList<std::pair<QString, QString>> titles() const;
  /// Marks a name; none where it is not in the list. Tells nobody.
  void mark(const QString& name);
  /// As wide as that, and as high as it takes.
  void fit(int width);
  /// Of a picture on the screen, in its own pixels.
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
