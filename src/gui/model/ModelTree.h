#pragma once
#include <QColor>
#include <vector>

#include "kit/TypeTree.h"
#include "velum/scene/ModelLayer.h"

namespace velum::gui {

/// The types of the scene's model with what is shown of them.
class ModelTree : public TypeTree {
  Q_OBJECT
 public:
  enum Column { Eye, Swatch, Name, Count, kColumns };
  enum Role { VisibleRole = kOwnRole, ColorRole };
  enum Shown { None, Some, All };  ///< of a row's types; what VisibleRole says

  explicit ModelTree(QObject* parent);
  /// Follows the layer; tells nobody where it is as before.
  void showLayer(const scene::ModelLayer& layer);
  int shownCount() const { return mShownCount; }

  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  Shown shownOf(const Row& row) const;
  QString tipOf(const Row& row, int column) const;
  QString describe(const MoleculeType& type) const;

  scene::ModelLayer mLayer;
  std::vector<bool> mVisible, mOwnColors;  ///< by type
  std::vector<QColor> mColors;
  int mShownCount = 0;
};

}  // namespace velum::gui
