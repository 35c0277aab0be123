#pragma once
#include <QCheckBox>
#include <QDialog>
#include <QRadioButton>

#include "gui/kit/Widgets.h"
#include "session/structure/StructureExport.h"

namespace velum::gui {

/// Asks which structures are exported, and how; the file's name is asked for after this dialog.
class ExportStructuresDialog : public QDialog {
  Q_OBJECT
 public:
  /// @param selected  ids of the selected structures; empty: only "all" can be chosen
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
