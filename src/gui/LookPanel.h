#pragma once
#include <QComboBox>
#include <QWidget>

#include "Widgets.h"
#include "velum/session/Document.h"

namespace velum::gui {

/// Preset, way of rendering, light and background. Reads the document, and changes it by edits only.
class LookPanel : public QWidget {
  Q_OBJECT
 public:
  LookPanel(session::Document& document, QWidget* parent);
  /// Shows the document as it is now.
  void refresh();

 private:
  QWidget* makeLook();
  QWidget* makeLight();
  QWidget* makeBackground();
  void fillPresets(Modality modality);
  void choosePreset(int index);
  void chooseMode(int index);
  void setBackground(glm::vec3 top, glm::vec3 bottom);

  session::Document& mDocument;
  QComboBox *mPreset = nullptr, *mMode = nullptr;
  QLabel* mIsoLabel = nullptr;
  NumberRow *mIso = nullptr, *mShadow = nullptr, *mOcclusion = nullptr;
  ColorButton *mTop = nullptr, *mBottom = nullptr;
  std::uint64_t mFilledFor = ~std::uint64_t(0);  ///< The volume that the preset list is grouped for.
};

}  // namespace velum::gui
