#pragma once
#include <QColor>
#include <optional>
#include <vector>

#include "gui/model/Equalizer.h"
#include "gui/rows/BarScale.h"
#include "gui/rows/TypeTree.h"
#include "scene/ModelLayer.h"

namespace velum::gui {

/// The types of the scene's model with what is shown of them, and how much: numbers are those of an equalizer's last
/// picture.
class ModelTree : public TypeTree {
  Q_OBJECT
 public:
  enum Column { Eye, Swatch, Name, Bar, Count, kColumns };
  enum Role { VisibleRole = kOwnRole, ColorRole };
  enum Shown { None, Some, All };  ///< of a row's types; what VisibleRole says

  ModelTree(const Equalizer& equalizer, QObject* parent);
  /// Follows the layer; tells nobody where it is as before.
  void showLayer(const scene::ModelLayer& layer);
  /// Follows the equalizer.
  void showCounts();
  int shownCount() const { return mShownCount; }
  const BarScale& scale() const { return mScale; }
  void setPercent(bool percent);
  /// What is known of a row's instances; nothing before there are counts: then `total` is 0.
  Counts countOf(const Row& row) const;
  /// What people have typed into a row's number: "50", "20 %"; nothing where it is no number.
  static std::optional<double> readNumber(const QString& text, double total);

  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 private:
  Shown shownOf(const Row& row) const;
  QString tipOf(const Row& row, int column) const;
  QString describe(const MoleculeType& type) const;
  QString describe(const Counts& count) const;
  QString numberOf(const Row& row) const;

  const Equalizer& mEqualizer;
  BarScale mScale;
  scene::ModelLayer mLayer;
  std::vector<bool> mVisible, mOwnColors;  ///< by type
  std::vector<QColor> mColors;
  int mShownCount = 0;
};

}  // namespace velum::gui
