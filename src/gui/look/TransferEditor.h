#pragma once
#include <QCheckBox>
#include <QPushButton>
#include <QStackedWidget>
#include <map>
#include <memory>
#include <tuple>

#include "gui/kit/Widgets.h"
#include "gui/look/TransferCanvas.h"
#include "gui/service/Job.h"
#include "session/document/Document.h"

namespace velum::gui {

/// The transfer function of the shown channel over its histogram, with exact numbers for the selected point or stop,
/// and the curve by gradient, where that is used. Reads the document, and changes it by edits only.
class TransferEditor : public QWidget {
  Q_OBJECT
 public:
  TransferEditor(session::Document& document, QWidget* parent);
  ~TransferEditor() override;
  /// Shows the document as it is now. The histogram of other data is counted in the background.
  void refresh();
  /// True when the histogram of the shown data has been counted.
  bool isComplete() const { return !mJob; }

 public slots:
  /// Draws a thin line at the value that is under the pointer in another view.
  void setProbe(double value) { mCanvas->setProbe(value); }
  void clearProbe() { mCanvas->setProbe(std::nullopt); }

 private:
  /// What a histogram is of: id of the volume's payload, channel, time step.
  using Key = std::tuple<std::uint64_t, int, int>;
  struct Histograms {
    Histogram values, gradients;
  };

  QWidget* makeHeader();
  QWidget* makeNumbers();
  void connectCanvas(TransferCanvas* canvas);
  void edit(const QString& label, const scene::TransferFunction& next, bool merge);
  void countHistograms();
  void showHistograms(const Histograms& histograms);
  void showNumbers();
  void useGradients(bool use);
  TransferCanvas* selected() const;
  Key shownKey() const;
  session::AxisView wholeAxis() const;

  session::Document& mDocument;
  TransferCanvas *mCanvas, *mGradients;
  QCheckBox* mUsesGradients;
  QPushButton *mLogarithmic = nullptr, *mFit = nullptr, *mRemove = nullptr;
  NumberField *mValue = nullptr, *mOpacity = nullptr;
  ColorButton* mColor = nullptr;
  QStackedWidget *mSecond = nullptr, *mNumbers = nullptr;
  bool mGradientsActive = false;  ///< The numbers are those of the gradient curve.
  Key mShown{0, -1, -1};          ///< What the canvas' histogram is of.
  /// The axis is fitted to the data, as the user has not moved it since the data came or was fitted.
  bool mIsFitted = false;
  std::map<Key, Histograms> mCache;
  std::unique_ptr<Job> mJob;
};

}  // namespace velum::gui
