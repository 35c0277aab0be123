#pragma once
#include <QImage>
#include <QMenu>
#include <QPixmap>

#include "gui/rows/PictureCard.h"
#include "session/document/Recent.h"

namespace velum::gui {

/// The picture of a recent file; null when there is none. @param logicalSize  size to which the picture is cut
QPixmap recentPixmap(const std::filesystem::path& file, QSize logicalSize, double pixelRatio);
/// Keeps a picture of the view, of any size, for a file. A cache that cannot be written is no error.
void saveRecentPicture(const std::filesystem::path& file, const QImage& image);

/// A recent file to click on: its picture, name and folder, and when it was open.
class RecentCard : public PictureCard {
  Q_OBJECT
 public:
  RecentCard(const session::RecentFile& file, QWidget* parent);
  const std::filesystem::path& path() const { return mFile.path; }

 private:
  session::RecentFile mFile;
};

/// A row of cards of recent files, as many as fit. Hidden while there are none.
class RecentRow : public QWidget {
  Q_OBJECT
 public:
  explicit RecentRow(QWidget* parent);
  /// Reads the list again.
  void refresh();

 signals:
  void chosen(const QString& path);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void addCard(const session::RecentFile& file);
  void placeCards();
  void askRemove(RecentCard* card, QPoint where);

  QList<RecentCard*> mCards;
  QWidget* mRow;
};

/// Fills a menu with the recent files, with their pictures, each time it opens.
void keepRecentMenu(QMenu* menu, std::function<void(const QString&)> open);

}  // namespace velum::gui
