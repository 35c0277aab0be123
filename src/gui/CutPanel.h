#pragma once
#include <QComboBox>
#include <QListWidget>
#include <QPushButton>
#include <QWidget>

#include "Widgets.h"
#include "velum/session/Document.h"

namespace velum::gui {

/// The list of cuts, and what can be done to the selected one.
class CutPanel : public QWidget {
  Q_OBJECT
 public:
  CutPanel(session::Document& document, QWidget* parent);
  void refresh();
  int selected() const { return mSelected; }

 public slots:
  void addPlane();
  void removeSelected();
  void flipSelected();

 signals:
  void selectionChanged(int index);

 private:
  void buildControls();
  void select(int index);
  void editSelected(const char* label, const std::function<void(scene::Cut&)>& change, bool merge = false);
  void snapTo(glm::dvec3 axis);

  session::Document& mDocument;
  QListWidget* mList;
  QPushButton* mRemove;
  QWidget* mControls;
  NumberRow* mPosition = nullptr;
  QComboBox* mFace = nullptr;
  QPushButton* mFlip = nullptr;
  int mSelected = -1;
};

}  // namespace velum::gui
