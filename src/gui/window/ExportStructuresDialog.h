#pragma once
#include <QCheckBox>
#include <QDialog>
#include <QRadioButton>

#include "gui/kit/Widgets.h"
#include "session/structure/StructureExport.h"

namespace velum::gui {

/// Which structures are exported, and how: the file is asked for after it.
class ExportStructuresDialog : public QDialog {
  Q_OBJECT
 public:
  /// @param selected  ids of those that are selected; empty: all is all there is to choose
  ExportStructuresDialog(const scene::Scene& scene, std::vector<int> selected, QWidget* parent);
  session::StructureExport options() const;

 private:
  void addChoice(QLayout* layout, const scene::Scene& scene);
  void addShape(QLayout* layout);

  std::vector<int> mSelected;
  QRadioButton *mAll = nullptr, *mOnly = nullptr;
  NumberRow* mSmooth = nullptr;
  QCheckBox* mApart = nullptr;
};

}  // namespace velum::gui
