#pragma once
#include <QComboBox>
#include <QLabel>
#include <QWidget>
#include <cstdint>
#include <memory>
#include <utility>

#include "gui/membrane/StrengthCanvas.h"
#include "gui/service/Selection.h"
#include "scene/Membrane.h"
#include "session/document/Document.h"
#include "session/look/ValueHistogram.h"

namespace velum::gui {

class Job;

/// The curves from values and gradients of the data to forces of the selected membrane, over histograms of these values
/// and gradients.
class StrengthForm : public QWidget {
  Q_OBJECT
 public:
  StrengthForm(session::Document& document, Selection& selection, QWidget* parent);
  ~StrengthForm() override;
  void showField(const scene::ForceField& field);

 private:
  void makeHead();
  void makeCanvas();
  bool byGradient() const { return mAttribute->currentIndex() == 1; }
  void showCurve();
  void countHistogram();

  session::Document& mDocument;
  Selection& mSelection;
  scene::ForceField mShown;
  QLabel* mTitle = nullptr;
  QComboBox* mAttribute = nullptr;
  StrengthCanvas* mCanvas;
  std::pair<std::uint64_t, int> mCounted{0, -1};  ///< The id of the volume and the channel that the histograms are of.
  Histogram mValues, mGradients;
  std::unique_ptr<Job> mJob;
};

}  // namespace velum::gui
