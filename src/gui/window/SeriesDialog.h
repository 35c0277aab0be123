#pragma once
#include <QComboBox>
#include <QDialog>
#include <QListWidget>

#include "core/Image.h"
#include "gui/service/Job.h"
#include "session/document/Series.h"

namespace velum::gui {

/// Which of several DICOM series is to be opened, each with its middle image, and with which segments of it.
class SeriesDialog : public QDialog {
  Q_OBJECT
 public:
  SeriesDialog(std::vector<session::Series> series, const QString& folder, QWidget* parent);

  /// The one that is chosen.
  const session::Series& series() const { return mSeries[std::size_t(row())]; }
  /// File of the segments that are chosen; empty: none.
  std::filesystem::path labels() const;

 private:
  int row() const;
  void showLabels();
  void drawPictures();
  void showPictures();

  struct Drawn;
  std::vector<session::Series> mSeries;
  QListWidget* mList;
  QComboBox* mLabels;
  std::shared_ptr<Drawn> mDrawn;
  Job* mJob;
};

}  // namespace velum::gui
