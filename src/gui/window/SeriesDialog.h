#pragma once
#include <QComboBox>
#include <QDialog>
#include <QListWidget>

#include "core/Image.h"
#include "gui/service/Job.h"
#include "session/document/Series.h"

namespace velum::gui {

/// Asks which of several DICOM series, or images of a store, is to be opened, and with which of its segments; shows
/// each with its middle image.
class SeriesDialog : public QDialog {
  Q_OBJECT
 public:
  SeriesDialog(std::vector<session::Series> series, const QString& folder, QWidget* parent);

  /// The series that is chosen.
  const session::Series& series() const { return mSeries[std::size_t(row())]; }
  /// The segments that are chosen; without a file: none are.
  session::SeriesLabels labels() const;

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
